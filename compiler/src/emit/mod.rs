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
#[cfg(feature = "icube")]
pub mod icube;
mod identifier;
#[cfg(feature = "igh")]
pub mod igh;
#[cfg(feature = "json")]
pub mod json;
#[cfg(feature = "lcec")]
pub mod lcec;
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
#[cfg(feature = "soes")]
pub mod soes;
#[cfg(feature = "program")]
mod steps;
#[cfg(feature = "structured-text")]
pub mod structured_text;
#[cfg(feature = "template")]
mod template;
#[cfg(feature = "wireshark")]
pub mod wireshark;

use std::collections::BTreeMap;

use crate::diagnostic::Rule;
use crate::lint::Checked;
use crate::model::Family;

/// An output.
pub trait Emitter: Sync {
    /// The name for `--emit`.
    fn name(&self) -> &'static str;

    /// What it makes, in one line.
    fn summary(&self) -> &'static str;

    /// How the names of its files end: `<family><end>`, or `<member><end>` where each member has one; a `/` in an end is that of
    /// a folder. No two outputs share an end, so that they do not share a file.
    fn ends(&self) -> &'static [&'static str];

    /// The rules of the group `output` that say what it cannot hold. They are asked where it is wanted.
    fn lints(&self) -> &'static [&'static Rule];

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
    /// Whether each chapter of the reference in Markdown is a file.
    pub chapters: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { editorial: true, dictionary: true, chapters: false }
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
    #[cfg(feature = "soes")]
    &soes::Soes,
    #[cfg(feature = "igh")]
    &igh::Igh,
    #[cfg(feature = "lcec")]
    &lcec::Lcec,
    #[cfg(feature = "icube")]
    &icube::Icube,
    #[cfg(feature = "python")]
    &python::Python,
    #[cfg(feature = "structured-text")]
    &structured_text::StructuredText,
    #[cfg(feature = "eds")]
    &eds::Eds,
    #[cfg(feature = "wireshark")]
    &wireshark::Wireshark,
    #[cfg(feature = "rust")]
    &rust::Rust,
];

/// The word for the outputs that are made where nobody says which are wanted, and that for every one.
pub const DEFAULT: &str = "default";
/// See [`DEFAULT`].
pub const EVERY: &str = "all";

/// The names of all outputs.
pub fn names() -> impl Iterator<Item = &'static str> {
    ALL.iter().map(|emitter| emitter.name())
}

/// The outputs that these names and words mean, in the order of the list.
pub fn wanted<'w>(words: impl IntoIterator<Item = &'w str> + Clone) -> Vec<&'static dyn Emitter> {
    let is_meant = |emitter: &&&dyn Emitter| {
        words.clone().into_iter().any(|word| match word {
            DEFAULT => emitter.is_default(),
            EVERY => true,
            name => name == emitter.name(),
        })
    };
    ALL.iter().filter(is_meant).copied().collect()
}

/// The outputs that are made where nobody says which are wanted.
pub fn default() -> impl Iterator<Item = &'static dyn Emitter> {
    ALL.iter().copied().filter(|emitter| emitter.is_default())
}

/// What is asked for these outputs.
pub fn lints(emitters: impl IntoIterator<Item = &'static dyn Emitter>) -> Vec<&'static Rule> {
    emitters.into_iter().flat_map(|emitter| emitter.lints()).copied().collect()
}

/// Files by name, in the folder of the family; one within a folder there has a `/` in its name.
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
    use crate::diagnostic::{Group, Rule};
    use crate::lint;

    #[test]
    #[cfg(feature = "cli")]
    fn each_rule_about_outputs_is_asked_for_one_and_no_other_is() {
        let asked = super::lints(ALL.iter().copied());
        let is_asked = |rule: &Rule| asked.iter().any(|asked| asked.name == rule.name);
        for lint in lint::ALL {
            assert_eq!(is_asked(lint.rule), lint.rule.group == Group::Output, "{}", lint.rule.name);
        }
    }

    #[test]
    #[cfg(feature = "cli")]
    fn the_docs_tell_what_each_output_cannot_hold() {
        let docs = include_str!("../../docs/outputs.md");
        for emitter in ALL {
            let name = format!("`{}`", emitter.name());
            let is_about = |line: &&str| {
                let of = line.strip_prefix("| ").and_then(|rest| rest.split(" |").next());
                of.is_some_and(|of| of == "every one" || of.split(", ").any(|of| of == name))
            };
            let rows: Vec<&str> = docs.lines().filter(is_about).collect();
            assert!(rows.len() > 1, "no row about {name}");
            for rule in emitter.lints() {
                let rule = format!("`{}`", rule.name);
                assert!(rows.iter().any(|row| row.contains(&rule)), "{name}: {rule}");
            }
        }
    }

    #[test]
    fn no_two_outputs_share_a_file() {
        let ends: Vec<&str> = ALL.iter().flat_map(|emitter| emitter.ends()).copied().collect();
        for (at, end) in ends.iter().enumerate() {
            assert!(end.starts_with('.'), "{end} is no end of a name");
            let others = ends.iter().enumerate().filter(|(other, _)| *other != at);
            // a family or a member has no folder in its name
            let shares = |other: &str| other.strip_suffix(end).is_some_and(|rest| !rest.contains('/'));
            let same: Vec<_> = others.filter(|(_, other)| shares(other)).collect();
            assert!(same.is_empty(), "{end} is the end of {same:?} too");
        }
    }
}
