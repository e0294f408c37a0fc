//! The kinds of change, by class.

mod compatible;
mod configuration;
mod documentation;
mod wire;

use std::fmt::Write as _;

pub(super) use compatible::*;
pub(super) use configuration::*;
pub(super) use documentation::*;
pub(super) use wire::*;

use super::change::{Class, Kind};
use crate::text::near::near;

/// Declares kinds of one class; the doc comment of each is its documentation.
macro_rules! kinds {
    ($class:ident: $($(#[doc = $doc:literal])+ $id:ident = $name:literal, $summary:literal;)+) => {
        $(
            $(#[doc = $doc])+
            pub(in crate::diff) static $id: $crate::diff::Kind = $crate::diff::Kind {
                rule: $crate::diagnostic::Rule {
                    name: $name,
                    group: $crate::diagnostic::Group::Changes,
                    level: $crate::diff::Class::$class.level(),
                    fixed: false,
                    summary: $summary,
                    docs: concat!($($doc, "\n"),+),
                },
                class: $crate::diff::Class::$class,
            };
        )+

        /// The kinds of this class.
        pub(super) const ALL: &[&$crate::diff::Kind] = &[$(&$id),+];
    };
}
use kinds;

/// All kinds, the worst first.
pub const ALL: [&[&Kind]; 4] = [wire::ALL, configuration::ALL, compatible::ALL, documentation::ALL];

/// The kind of this name.
///
/// # Errors
/// If there is none: the name that looks most like it, if one does.
pub fn find(name: &str) -> Result<&'static Kind, Option<&'static str>> {
    let kinds = || ALL.into_iter().flatten().copied();
    let names = || kinds().map(|kind| kind.rule.name);
    kinds().find(|kind| kind.rule.name == name).ok_or_else(|| near(name, names()))
}

/// The reference of all kinds, in Markdown.
pub fn reference() -> String {
    let mut out = String::from(PREFACE);
    for class in Class::ALL {
        let kinds = || ALL.into_iter().flatten().filter(move |kind| kind.class == class);
        let _ = write!(
            out,
            "\n## {}\n\n{}.\n\n| change | what |\n|---|---|\n",
            class.name(),
            capital(class.about())
        );
        kinds().for_each(|kind| {
            let _ = writeln!(out, "| [`{0}`](#{0}) | {1} |", kind.rule.name, kind.rule.summary);
        });
        kinds().for_each(|kind| {
            let _ = write!(out, "\n### {}\n\n{}\n", kind.rule.name, kind.text());
        });
    }
    out
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

const PREFACE: &str = "\
<!-- Generated from the doc comments of the kinds; `cargo accept` brings it up to date. -->

# Changes

`devc diff` compares two versions of a description and names the kind of each change. The same text comes from
`devc explain changed-type`. A change is judged from the view of an old configuration on a new device: of a master
project, a program or a start-up list that was made for the old version and is left as it is.
";
