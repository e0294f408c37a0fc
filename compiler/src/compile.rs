//! The pipeline.

use std::path::{Path, PathBuf};

use crate::diagnostic::{Diagnostic, Diagnostics, Rule, faults};
use crate::emit;
use crate::lint::{self, Checked, Levels};
use crate::model::Family;
use crate::resolve::Resolved;
use crate::source::{Document, Loader, Sources, load};
use crate::text::characters::hazard;
use crate::{profiles, raw, resolve};

/// What came of a description.
#[derive(Debug, Default)]
pub struct Compilation {
    /// The devices; none if an error forbids it.
    pub family: Option<Checked<Family>>,
    /// The messages, sorted.
    pub diagnostics: Diagnostics,
    /// The texts that the messages point into.
    pub sources: Sources,
    /// Every file that was read, for those who have to notice a change.
    pub files: Vec<PathBuf>,
    /// What was read, as far as it could be; none if there was nothing to read.
    pub document: Option<Document>,
}

/// A stage of the pipeline.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// Files read and parsed.
    Load,
    /// Tables turned into the format's structs.
    Decode,
    /// Axes written out, references bound, PDOs laid out.
    Resolve,
    /// Rules asked.
    Check,
}

impl Stage {
    /// The name in lower case.
    pub fn name(self) -> &'static str {
        match self {
            Self::Load => "load",
            Self::Decode => "decode",
            Self::Resolve => "resolve",
            Self::Check => "check",
        }
    }
}

/// What is asked of a description.
#[derive(Debug, Clone)]
pub struct Request {
    /// Levels over those that the description sets.
    pub levels: Levels,
    /// The rules of the group `output` that are asked: those of the outputs that are wanted.
    pub outputs: Vec<&'static Rule>,
}

/// What is asked where nobody says which outputs are wanted.
impl Default for Request {
    fn default() -> Self {
        Self { levels: Levels::default(), outputs: emit::lints(emit::default()) }
    }
}

/// Compiles the description at `path`: a folder with a `device.toml`, or that file.
///
/// A stage runs if the one before left no error; inside a stage everything is reported.
pub fn compile(loader: &dyn Loader, path: &Path) -> Compilation {
    compile_with(loader, path, &Request::default(), &mut |_| ())
}

/// Compiles as [`compile`] does, asks what is requested, and tells `enter` each stage as it begins.
pub fn compile_with(
    loader: &dyn Loader,
    path: &Path,
    request: &Request,
    enter: &mut dyn FnMut(Stage),
) -> Compilation {
    let mut compilation = Compilation::default();
    compilation.family = stages(loader, path, request, &mut compilation, enter);
    compilation.diagnostics.finish();
    compilation
}

fn stages(
    loader: &dyn Loader,
    path: &Path,
    request: &Request,
    compilation: &mut Compilation,
    enter: &mut dyn FnMut(Stage),
) -> Option<Checked<Family>> {
    let (resolved, mut levels) = resolved(loader, path, compilation, enter)?;
    levels.extend(&request.levels);
    enter(Stage::Check);
    lint::check(resolved, &levels, &request.outputs, &compilation.sources, &mut compilation.diagnostics)
}

/// The devices before any rule has seen them, as written and as they hold, with the levels that their description gives
/// the rules.
pub(crate) fn resolved(
    loader: &dyn Loader,
    path: &Path,
    compilation: &mut Compilation,
    enter: &mut dyn FnMut(Stage),
) -> Option<(Resolved, Levels)> {
    let Compilation { diagnostics, sources, files, document, .. } = compilation;
    enter(Stage::Load);
    let document = document.insert(load(loader, path, profiles::ALL, sources, diagnostics)?);
    files.clone_from(&document.files);
    let id = id(loader, path);
    diagnostics.extend(bad_name(&id));
    if diagnostics.has_errors() {
        return None;
    }
    enter(Stage::Decode);
    let members = raw::read(document, &id, sources, diagnostics);
    if diagnostics.has_errors() {
        return None;
    }
    let levels = members.first().map(|member| Levels::described(&member.printed.lints)).unwrap_or_default();
    enter(Stage::Resolve);
    let resolved = resolve::resolve(&id, members, diagnostics)?;
    Some((resolved, levels))
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

/// That the folder's name has something in it that no key may have, if it has.
fn bad_name(id: &str) -> Option<Diagnostic> {
    let odd = id.chars().find(|c| matches!(c, '\n' | '\t') || hazard(*c).is_some())?;
    let message = format!("the folder `{id}` has U+{:04X} in its name", u32::from(odd));
    Some(
        Diagnostic::bare(&faults::FORBIDDEN_CHARACTER, message)
            .note("the outputs take their names from the folder")
            .help("rename the folder"),
    )
}
