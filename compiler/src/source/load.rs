//! A description with all it includes and the profiles it builds on.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::include::Reader;
use super::loader::{shown, similar};
use super::merge::{merge, with_default_source};
use super::parse::parse;
use super::settings::Settings;
use super::{Layer, Loader, Location, Members, SourceFile, Sources, Table, limits};
use crate::diagnostic::{Diagnostic, Diagnostics, faults};
use crate::text::near::{list, near};

/// The file of a description that is given by its folder.
pub const MAIN_FILE: &str = "device.toml";

/// A profile: a text that devc brings along.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Profile {
    /// The name that a description gives it.
    pub name: &'static str,
    /// TOML in the format of a description.
    pub text: &'static str,
}

/// All that was read for one description.
#[derive(Debug, Clone, PartialEq)]
pub struct Document {
    /// The files of the description, merged.
    pub root: Table,
    /// The profiles it names, later ones laid over earlier ones.
    pub profile: Table,
    /// Every file read, in the order in which it was read.
    pub files: Vec<PathBuf>,
}

/// Reads the description at `path`: a folder with a `device.toml`, or a TOML file.
///
/// Every file that can be reached is read and every fault reported; none if there is no file to start with.
pub fn load(
    loader: &dyn Loader,
    path: &Path,
    profiles: &[Profile],
    sources: &mut Sources,
    diagnostics: &mut Diagnostics,
) -> Option<Document> {
    let main = main_file(loader, path).map_err(|fault| diagnostics.push(fault)).ok()?;
    let mut reader = Reader::new(loader, &main, sources, diagnostics)?;
    reader.read(&main);
    let (parts, files) = (reader.parts, reader.files);
    let mut wanted = Vec::new();
    let tables = parts.into_iter().map(|part| {
        wanted.extend(part.settings.profiles);
        with_default_source(part.table, part.settings.source.as_ref())
    });
    let root = merge(tables, diagnostics)?;
    limits::check(&root, diagnostics);
    let profile = layer(&wanted, profiles, root.at, sources, diagnostics);
    Some(Document { root, profile, files })
}

/// The file to start with.
fn main_file(loader: &dyn Loader, path: &Path) -> Result<PathBuf, Diagnostic> {
    let missing = |message| Diagnostic::bare(&faults::MISSING_FILE, message);
    let shown = shown(path);
    if loader.canonical(path).is_err() {
        let diagnostic = missing(format!("`{shown}` does not exist"));
        return Err(match similar(loader, path) {
            Some(other) => diagnostic.help(format!("`{other}` lies beside it")),
            None => diagnostic,
        });
    }
    if path.extension().is_some_and(|extension| extension == "toml") {
        return Ok(path.to_owned());
    }
    let main = path.join(MAIN_FILE);
    if loader.canonical(&main).is_err() {
        return Err(missing(format!("`{shown}` holds no description"))
            .note(format!("a description is a folder with a `{MAIN_FILE}`, or a TOML file"))
            .help(format!("give a folder that has a `{MAIN_FILE}`, or name the file")));
    }
    Ok(main)
}

/// The profiles that a description names, each once, later ones over earlier ones.
fn layer(
    wanted: &[(Arc<str>, Location)],
    profiles: &[Profile],
    at: Location,
    sources: &mut Sources,
    diagnostics: &mut Diagnostics,
) -> Table {
    let mut seen: BTreeSet<&str> = BTreeSet::new();
    let mut layered = Table { at: Location { end: at.start, ..at }, members: Members::default() };
    for (name, at) in wanted {
        if !seen.insert(name) {
            continue;
        }
        match profiles.iter().find(|profile| profile.name == &**name) {
            Some(profile) => layered = read_profile(profile, sources, diagnostics).over(&layered),
            None => diagnostics.push(unknown_profile(name, *at, profiles)),
        }
    }
    layered
}

/// A profile as a tree.
pub(crate) fn read_profile(profile: &Profile, sources: &mut Sources, diagnostics: &mut Diagnostics) -> Table {
    let path = format!("<profile {}>", profile.name);
    let file = sources.add(SourceFile { path, text: profile.text.to_owned(), embedded: true });
    let mut table = parse(file, profile.text, Layer::Profile, diagnostics);
    let settings = Settings::take(&mut table, diagnostics);
    with_default_source(table, settings.source.as_ref())
}

fn unknown_profile(name: &str, at: Location, profiles: &[Profile]) -> Diagnostic {
    let names: Vec<&str> = profiles.iter().map(|profile| profile.name).collect();
    let message = format!("there is no profile `{name}`");
    let label = format!("devc has {}", list(&names));
    let diagnostic = Diagnostic::new(&faults::UNKNOWN_PROFILE, message, at, label);
    match near(name, names.iter().copied()) {
        Some(other) => diagnostic.fix(format!("did you mean `{other}`?"), at, format!("\"{other}\"")),
        None => diagnostic,
    }
}
