//! The outputs: one folder each, one line each in [`ALL`].
//!
//! An emitter gets a checked family and makes files of it. It cannot fail: what an output cannot express
//! is a rule, and was reported before.

#[cfg(all(test, feature = "cli"))]
mod dangerous;
mod escape;
#[cfg(feature = "esi")]
pub mod esi;
#[cfg(feature = "json")]
pub mod json;
#[cfg(feature = "markdown")]
pub mod markdown;
pub mod rust;

use std::collections::BTreeMap;

use crate::lint::Checked;
use crate::model::Family;

/// An output.
pub trait Emitter: Sync {
    /// The name for `--emit`, and the extension of its file.
    fn name(&self) -> &'static str;

    /// What it makes, in one line.
    fn summary(&self) -> &'static str;

    /// The text of the file `<family>.<name>`.
    fn emit(&self, family: &Checked<Family>, options: &Options) -> String;
}

/// What outputs can be made with or without.
#[derive(Debug, Clone, Copy)]
pub struct Options {
    /// Whether a reference for people shows how sure facts are: errata, remarks, assumptions, and marks beside what no
    /// source states. A vendor's customers may do without.
    pub editorial: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { editorial: true }
    }
}

/// The outputs that this build of devc can make.
pub static ALL: &[&dyn Emitter] = &[
    #[cfg(feature = "esi")]
    &esi::Esi,
    #[cfg(feature = "markdown")]
    &markdown::Markdown,
    #[cfg(feature = "json")]
    &json::Json,
    #[cfg(feature = "rust")]
    &rust::Rust,
];

/// Files by name, relative to the output folder.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Files(pub BTreeMap<String, String>);

/// Makes the outputs of `emitters`: `<family>/<family>.<name>` each.
pub fn emit(family: &Checked<Family>, emitters: &[&dyn Emitter], options: &Options) -> Files {
    let id = &family.id;
    let files = emitters.iter().map(|emitter| {
        let name = emitter.name();
        (format!("{id}/{id}.{name}"), emitter.emit(family, options))
    });
    Files(files.collect())
}
