//! What a project wants of devc: `devc.toml`, in the folder that its descriptions lie under.
//!
//! It is no part of a description: that says what a device is, is copied from project to project, and is read by derives.
//! Where files go on a disk is for those to say whose disk it is.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};
use std::sync::LazyLock;

use serde::Deserialize;
use serde::de::{Deserializer, Error};

use crate::diagnostic::{Diagnostic, Diagnostics, faults};
use crate::emit;
use crate::raw::decode::Reader;
use crate::source::parse::parse;
use crate::source::{FileId, Layer, Loader, SourceFile, Sources};

/// The name of the file.
pub const PROJECT_FILE: &str = "devc.toml";

/// What `[outputs]` says.
#[derive(Debug, Clone, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case", default)]
pub struct Outputs {
    /// The outputs to make, as `--emit` has them.
    pub emit: Option<Vec<Wanted>>,
    /// The folder for the outputs, as `--out` has it.
    pub out: Option<Folder>,
    /// The folders of outputs that go elsewhere.
    pub folders: BTreeMap<Output, Folder>,
    /// Whether a reference shows how sure facts are; `--no-editorial` says that it does not.
    pub editorial: Option<bool>,
    /// Whether Rust has the dictionary for a firmware; `--no-dictionary` says that it does not.
    pub dictionary: Option<bool>,
    /// Whether each chapter of the reference in Markdown is a file, as `--chapters` has it.
    pub chapters: Option<bool>,
}

/// What the file says.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Project {
    outputs: Outputs,
}

/// The name of an output, or a word for several.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wanted(pub &'static str);

/// The name of an output.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Output(pub &'static str);

/// A folder inside that of the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Folder(pub PathBuf);

impl<'de> Deserialize<'de> for Wanted {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        static WORDS: LazyLock<Vec<&str>> =
            LazyLock::new(|| emit::names().chain([emit::DEFAULT, emit::EVERY]).collect());
        one_of(deserializer, &WORDS).map(Self)
    }
}

impl<'de> Deserialize<'de> for Output {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        static NAMES: LazyLock<Vec<&str>> = LazyLock::new(|| emit::names().collect());
        one_of(deserializer, &NAMES).map(Self)
    }
}

fn one_of<'de, D: Deserializer<'de>>(
    deserializer: D,
    known: &'static [&'static str],
) -> Result<&'static str, D::Error> {
    let word = String::deserialize(deserializer)?;
    let found = known.iter().find(|name| **name == word);
    found.copied().ok_or_else(|| D::Error::unknown_variant(&word, known))
}

impl<'de> Deserialize<'de> for Folder {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let path = Path::new(&text);
        let is_inside =
            path.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
        match is_inside {
            true => Ok(Self(path.to_owned())),
            false => Err(D::Error::custom(format!("`{text}` leads out of the folder of `{PROJECT_FILE}`"))),
        }
    }
}

/// What was read.
#[derive(Debug, Default)]
pub struct Read {
    /// What is wanted, as far as it could be read.
    pub outputs: Outputs,
    /// The messages.
    pub diagnostics: Diagnostics,
    /// The text that they point into.
    pub sources: Sources,
}

/// Reads the file at `path`.
pub fn read(loader: &dyn Loader, path: &Path) -> Read {
    let mut read = Read::default();
    let Read { outputs, diagnostics, sources } = &mut read;
    match text(loader, path) {
        Ok(text) => {
            let path = path.to_string_lossy().into_owned();
            let file = sources.add(SourceFile { path, text, embedded: false });
            *outputs = decoded(file, sources, diagnostics).unwrap_or_default();
        }
        Err(reason) => {
            let message = format!("cannot read `{}`: {reason}", path.display());
            diagnostics.push(Diagnostic::bare(&faults::UNREADABLE_FILE, message));
        }
    }
    diagnostics.finish();
    read
}

fn text(loader: &dyn Loader, path: &Path) -> Result<String, String> {
    let opened = loader.read(path).map_err(|error| error.to_string())?;
    String::from_utf8(opened.bytes).map_err(|_| "it is not UTF-8".to_owned())
}

fn decoded(file: FileId, sources: &Sources, diagnostics: &mut Diagnostics) -> Option<Outputs> {
    let text = &sources.get(file)?.text;
    let table = parse(file, text, Layer::Description, diagnostics);
    let mut reader = Reader::new(&table, diagnostics);
    let project: Option<Project> = reader.part();
    reader.finish();
    Some(project?.outputs)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::render::{Style, text};
    use crate::source::Memory;

    fn said(content: &str) -> (Outputs, String) {
        let read = read(&Memory::new().with("devc.toml", content), Path::new("devc.toml"));
        let messages = read.diagnostics.iter().map(|it| text(it, &read.sources, Style::Plain));
        (read.outputs, messages.collect())
    }

    #[test]
    fn outputs_folders_and_options_are_read() {
        let (outputs, said) = said(
            "[outputs]\nemit = [\"default\", \"c\"]\nout = \"made\"\neditorial = false\nfolders = { c = \"firmware/gen\" }\n",
        );
        assert_eq!(said, "");
        assert_eq!(outputs.emit, Some(vec![Wanted("default"), Wanted("c")]));
        assert_eq!(outputs.out, Some(Folder("made".into())));
        assert_eq!(outputs.editorial, Some(false));
        assert_eq!(outputs.folders, [(Output("c"), Folder("firmware/gen".into()))].into());
        assert_eq!(said_of(""), "");
    }

    fn said_of(content: &str) -> String {
        said(content).1
    }

    #[test]
    fn mistakes_are_answered_at_their_place() {
        for (content, expected) in [
            ("[output]\n", "did you mean `outputs`?"),
            ("[outputs]\nemitt = []\n", "did you mean `emit`?"),
            ("[outputs]\nemit = [\"pyton\"]\n", "did you mean `python`?"),
            ("[outputs]\nemit = [\"md\", \"defualt\"]\n", "did you mean `default`?"),
            ("[outputs.folders]\npyhton = \"a\"\n", "did you mean `python`?"),
            ("[outputs]\nout = \"../a\"\n", "leads out of the folder"),
            ("[outputs]\nout = \"/a\"\n", "leads out of the folder"),
            ("[outputs]\nemit = \"md\"\n", "expected an array, found a string"),
            ("[outputs\n", "devc.toml:1"),
        ] {
            let said = said_of(content);
            assert!(said.contains(expected) && said.contains("devc.toml"), "{content}: {said}");
        }
    }
}
