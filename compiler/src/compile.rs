//! The pipeline.

use std::path::{Path, PathBuf};

use crate::diagnostic::Diagnostics;
use crate::lint::{self, Checked, Levels};
use crate::model::Family;
use crate::source::{Loader, Sources, load};
use crate::{profiles, raw, resolve};

/// What came of a description.
#[derive(Debug)]
pub struct Compilation {
    /// The devices; none if an error forbids it.
    pub family: Option<Checked<Family>>,
    /// The messages, sorted.
    pub diagnostics: Diagnostics,
    /// The texts that the messages point into.
    pub sources: Sources,
    /// Every file that was read, for those who have to notice a change.
    pub files: Vec<PathBuf>,
}

/// Compiles the description at `path`: a folder with a `device.toml`, or that file.
///
/// A stage runs if the one before left no error; inside a stage everything is reported.
pub fn compile(loader: &dyn Loader, path: &Path) -> Compilation {
    let mut sources = Sources::default();
    let mut diagnostics = Diagnostics::default();
    let mut files = Vec::new();
    let family = stages(loader, path, &mut sources, &mut diagnostics, &mut files);
    diagnostics.finish();
    Compilation { family, diagnostics, sources, files }
}

fn stages(
    loader: &dyn Loader,
    path: &Path,
    sources: &mut Sources,
    diagnostics: &mut Diagnostics,
    files: &mut Vec<PathBuf>,
) -> Option<Checked<Family>> {
    let document = load(loader, path, profiles::ALL, sources, diagnostics);
    let document = document?;
    files.extend(document.files.iter().cloned());
    if diagnostics.has_errors() {
        return None;
    }
    let id = id(loader, path);
    let members = raw::read(&document, &id, diagnostics);
    if diagnostics.has_errors() {
        return None;
    }
    let levels = members.first().map(|device| Levels::described(&device.lints)).unwrap_or_default();
    let family = resolve::resolve(&id, members, sources, diagnostics)?;
    lint::check(family, &levels, diagnostics)
}

/// The name of the description's folder, from which the outputs take theirs.
fn id(loader: &dyn Loader, path: &Path) -> String {
    let path = loader.canonical(path).unwrap_or_else(|_| path.to_owned());
    let folder = if path.extension().is_some_and(|extension| extension == "toml") {
        path.parent().unwrap_or(&path)
    } else {
        &path
    };
    folder.file_name().map_or_else(|| "device".to_owned(), |name| name.to_string_lossy().into_owned())
}
