//! Compilation beside the answers, so that nobody waits for it.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::mpsc::Receiver;

use devc::diagnostic::Rule;
use devc::project::PROJECT_FILE;
use devc::source::Disk;
use devc::{Compilation, emit, project};

use super::overlay::Overlay;
use crate::project::{Project, root};

/// A description to compile.
pub(super) struct Job {
    pub(super) main: PathBuf,
    pub(super) overlay: Overlay,
    /// The versions of the texts that are open.
    pub(super) versions: BTreeMap<PathBuf, i32>,
}

/// What came of it.
pub(super) struct Compiled {
    pub(super) main: PathBuf,
    pub(super) compilation: Compilation,
    pub(super) versions: BTreeMap<PathBuf, i32>,
}

impl Job {
    pub(super) fn run(self) -> Compiled {
        let request = devc::Request { outputs: wanted(), ..devc::Request::default() };
        let compilation = devc::compile_with(&self.overlay, &self.main, &request, &mut |_| ());
        Compiled { compilation, main: self.main, versions: self.versions }
    }
}

/// What is asked for the outputs of the project that the server runs in.
fn wanted() -> Vec<&'static Rule> {
    let read = root().map(|root| project::read(&Disk, &root.join(PROJECT_FILE)));
    let outputs = read.map(|read| read.outputs).unwrap_or_default();
    emit::lints(Project { outputs, ..Project::default() }.checked())
}

/// Does one job after the other and tells what came of it, as long as there are jobs and somebody listens.
pub(super) fn work(jobs: &Receiver<Job>, tell: impl Fn(Compiled) -> bool) {
    let _ = jobs.iter().map(Job::run).all(tell);
}
