//! Compilation beside the answers, so that nobody waits for it.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::mpsc::Receiver;

use devc::Compilation;

use super::overlay::Overlay;

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
        let compilation = devc::compile(&self.overlay, &self.main);
        Compiled { compilation, main: self.main, versions: self.versions }
    }
}

/// Does one job after the other and tells what came of it, as long as there are jobs and somebody listens.
pub(super) fn work(jobs: &Receiver<Job>, tell: impl Fn(Compiled) -> bool) {
    let _ = jobs.iter().map(Job::run).all(tell);
}
