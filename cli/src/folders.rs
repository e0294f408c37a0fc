//! Where outputs go.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use devc::emit::Emitter;

use super::project::Project;

/// Where outputs go if nobody says anything.
const DEFAULT: &str = "generated";

/// The folder of each output, in which each description has one of its own.
#[derive(Debug)]
pub(super) struct Folders {
    out: PathBuf,
    /// Those that go elsewhere, by name.
    own: BTreeMap<&'static str, PathBuf>,
}

impl Folders {
    /// All go where the command line says; if it says nothing, where the project wants each.
    pub(super) fn new(out: Option<&Path>, project: &Project) -> Self {
        if let Some(out) = out {
            return Self { out: out.to_owned(), own: BTreeMap::new() };
        }
        let beneath = |folder: &Path| project.root.join(folder);
        let outputs = &project.outputs;
        Self {
            out: beneath(outputs.out.as_ref().map_or(Path::new(DEFAULT), |out| &out.0)),
            own: outputs.folders.iter().map(|(output, folder)| (output.0, beneath(&folder.0))).collect(),
        }
    }

    /// The folder of an output.
    pub(super) fn of(&self, emitter: &dyn Emitter) -> PathBuf {
        self.own.get(emitter.name()).unwrap_or(&self.out).clone()
    }

    /// The folders of these outputs, each once.
    pub(super) fn all(&self, emitters: &[&'static dyn Emitter]) -> BTreeSet<PathBuf> {
        emitters.iter().map(|emitter| self.of(*emitter)).collect()
    }
}
