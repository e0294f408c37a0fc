//! The outputs: one folder each, one line each in [`ALL`].
//!
//! An emitter gets a checked family and makes files of it, one for the family or one a member. It cannot fail: what an
//! output cannot express is a rule, and was reported before.

#[cfg(feature = "c")]
pub mod c;
#[cfg(all(test, feature = "cli"))]
mod dangerous;
#[cfg(feature = "eds")]
pub mod eds;
mod escape;
#[cfg(feature = "esi")]
pub mod esi;
#[cfg(feature = "html")]
pub mod html;
mod identifier;
#[cfg(feature = "igh")]
pub mod igh;
#[cfg(feature = "json")]
pub mod json;
#[cfg(feature = "markdown")]
pub mod markdown;
#[cfg(feature = "program")]
mod program;
#[cfg(feature = "python")]
pub mod python;
pub mod rust;
#[cfg(feature = "sii")]
pub mod sii;
#[cfg(all(test, feature = "cli"))]
mod skeleton;
#[cfg(feature = "program")]
mod steps;
#[cfg(feature = "template")]
mod template;

use std::collections::BTreeMap;

use crate::lint::Checked;
use crate::model::Family;

/// An output.
pub trait Emitter: Sync {
    /// The name for `--emit`.
    fn name(&self) -> &'static str;

    /// What it makes, in one line.
    fn summary(&self) -> &'static str;

    /// How the names of its files end: `<family><end>`, or `<member><end>` where each member has one. No two outputs share
    /// an end, so that they do not share a file.
    fn ends(&self) -> &'static [&'static str];

    /// Whether it is made where nobody says which outputs are wanted.
    fn is_default(&self) -> bool;

    /// Its files.
    fn emit(&self, family: &Checked<Family>, options: &Options) -> Files;
}

/// What outputs can be made with or without.
#[derive(Debug, Clone, Copy)]
pub struct Options {
    /// Whether a reference for people shows how sure facts are: errata, remarks, assumptions, and marks beside what no
    /// source states. A vendor's customers may do without.
    pub editorial: bool,
    /// Whether Rust has the dictionary for a firmware. Masters do without.
    pub dictionary: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { editorial: true, dictionary: true }
    }
}

/// The outputs that this build of devc can make.
pub static ALL: &[&dyn Emitter] = &[
    #[cfg(feature = "esi")]
    &esi::Esi,
    #[cfg(feature = "markdown")]
    &markdown::Markdown,
    #[cfg(feature = "html")]
    &html::Html,
    #[cfg(feature = "json")]
    &json::Json,
    #[cfg(feature = "sii")]
    &sii::Sii,
    #[cfg(feature = "c")]
    &c::C,
    #[cfg(feature = "igh")]
    &igh::Igh,
    #[cfg(feature = "python")]
    &python::Python,
    #[cfg(feature = "eds")]
    &eds::Eds,
    #[cfg(feature = "rust")]
    &rust::Rust,
];

/// Files by name, in the folder of the family.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Files(pub BTreeMap<String, Vec<u8>>);

impl Files {
    /// One file.
    pub fn one(name: String, content: impl Into<Vec<u8>>) -> Self {
        Self([(name, content.into())].into())
    }

    /// The text of the first file whose name ends like this, if there is one and it is text.
    pub fn text(&self, end: &str) -> Option<&str> {
        let (_, content) = self.0.iter().find(|(name, _)| name.ends_with(end))?;
        std::str::from_utf8(content).ok()
    }
}

/// Makes the outputs of `emitters`.
pub fn emit(family: &Checked<Family>, emitters: &[&dyn Emitter], options: &Options) -> Files {
    Files(emitters.iter().flat_map(|emitter| emitter.emit(family, options).0).collect())
}

#[cfg(test)]
mod tests {
    use super::ALL;

    #[test]
    fn no_two_outputs_share_a_file() {
        let ends: Vec<&str> = ALL.iter().flat_map(|emitter| emitter.ends()).copied().collect();
        for (at, end) in ends.iter().enumerate() {
            assert!(end.starts_with('.'), "{end} is no end of a name");
            let others = ends.iter().enumerate().filter(|(other, _)| *other != at);
            let same: Vec<_> = others.filter(|(_, other)| other.ends_with(end)).collect();
            assert!(same.is_empty(), "{end} is the end of {same:?} too");
        }
    }
}
