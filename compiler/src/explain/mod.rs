//! What devc knows of a word: the rule or the kind of change of this name, or what the profiles say of it.
//!
//! Questions are asked of trees, as files of TOML are parsed into, so that a description can be asked as well.

mod bits;
mod bytes;
mod entity;
mod find;
mod layout;
mod near;
mod noun;
mod outline;
mod relation;
mod tree;
mod view;
mod word;

use std::path::Path;

use crate::diagnostic::{Diagnostics, Rule};
use crate::diff::Kind;
use crate::raw::over_profile;
#[cfg(feature = "lsp")]
use crate::source::Table;
use crate::source::{Loader, Sources, load};
use crate::{diff, profiles, rules};
pub use bits::word as explain_word;
pub use bytes::bytes as explain_bytes;
#[cfg(feature = "lsp")]
use entity::Entity;
use find::{Found, find};
use tree::Trees;
use word::Phrase;

/// That nothing is known of a word.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unknown {
    /// What is known and looks like it, the most alike first.
    pub near: Vec<String>,
}

/// Tells what is known of some words: the name of a rule, a kind of change or a profile; an index, a code, an id or a name of what profiles
/// have, which the name of a profile and a word such as `mode` or `error` in front may narrow.
///
/// # Errors
/// If nothing is known of them.
pub fn explain(words: &[String]) -> Result<String, Unknown> {
    if let [name] = words
        && let Ok(rule) = rules::find(name)
    {
        return Ok(of_rule(rule));
    }
    if let [name] = words
        && let Ok(kind) = diff::find(name)
    {
        return Ok(of_kind(kind));
    }
    answer(&Trees::of(profiles::ALL), &Phrase::new(words))
}

/// Tells what the description at `path` says of some words, as [`explain`] tells of profiles; none if there is no
/// description that can be read.
///
/// # Errors
/// If it says nothing of them.
pub fn explain_description(
    loader: &dyn Loader,
    path: &Path,
    words: &[String],
) -> Option<Result<String, Unknown>> {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let document = load(loader, path, profiles::ALL, &mut sources, &mut diagnostics)?;
    let root = over_profile(&document.root, &document.profile);
    let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let phrase = Phrase::new(words);
    let own = answer(&Trees::one(name, root, sources), &phrase);
    Some(own.or_else(|unknown| of_protocol(&phrase).ok_or(unknown)))
}

/// Sections of profiles that hold for every device, whether its description mentions them or not.
const OF_THE_PROTOCOL: [&str; 1] = ["abort-codes"];

/// What holds for every device.
fn of_protocol(phrase: &Phrase) -> Option<String> {
    let trees = Trees::of(profiles::ALL);
    let parts = find(&trees, phrase).into_iter().filter_map(|found| match found {
        Found::Entity(entity) if OF_THE_PROTOCOL.contains(&entity.section) => {
            Some(view::of_entity(&trees, entity))
        }
        _ => None,
    });
    let parts: Vec<String> = parts.collect();
    (!parts.is_empty()).then(|| parts.join("\n\n"))
}

/// Tells what a tree says of the thing under a key of a section, or of one of its entries; none if it has no such thing.
#[cfg(feature = "lsp")]
pub(crate) fn explain_thing(
    name: &str,
    root: &Table,
    sources: &Sources,
    section: &str,
    key: &str,
    subindex: Option<i64>,
) -> Option<String> {
    let trees = Trees::one(name.to_owned(), root.clone(), sources.clone());
    let mut entities = trees.trees.iter().flat_map(Entity::all);
    let entity = entities.find(|entity| entity.section == section && entity.key == key)?;
    match subindex {
        Some(subindex) => Some(view::of_entry(&trees, entity, entity.entry(subindex)?)),
        None => Some(view::of_entity(&trees, entity)),
    }
}

/// What trees say of a phrase.
fn answer(trees: &Trees, phrase: &Phrase) -> Result<String, Unknown> {
    let parts = find(trees, phrase).into_iter().map(|found| match found {
        Found::Tree(tree) => outline::of_tree(tree),
        Found::Section(entities) => outline::of_section(&entities),
        Found::Entity(entity) => view::of_entity(trees, entity),
        Found::Entry(entity, entry) => view::of_entry(trees, entity, entry),
    });
    let parts: Vec<String> = parts.collect();
    if parts.is_empty() { Err(Unknown { near: near::near(trees, phrase) }) } else { Ok(parts.join("\n\n")) }
}

/// A rule with all that its author says of it.
fn of_rule(rule: &Rule) -> String {
    let (summary, level, docs) = (rule.summary, rules::default_level(rule), rules::docs(rule));
    format!("{}: {summary} ({level})\n\n{docs}", rule.name)
}

/// A kind of change with all that its author says of it.
fn of_kind(kind: &Kind) -> String {
    format!("{}: {} ({})\n\n{}", kind.rule.name, kind.rule.summary, kind.class.name(), kind.text())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Profile;

    fn ask(text: &'static str, words: &str) -> Result<String, Unknown> {
        answer(&Trees::of(&[Profile { name: "test", text }]), &Phrase::new(&[words.to_owned()]))
    }

    #[test]
    fn what_is_written_is_shown_as_it_is_written() {
        let text = "source = \"ETG.1000\"\n[errors.0x2310]\nname = \"Overcurrent\"\nregister = 0x03\n\
                    vendor-codes = [7, 0x08]\n[homing-bits.x]\nbits = { start = 4, done = 0xA }\n";
        let expected = "error 0x2310 of test: Overcurrent\n\n  register      0x03\n  vendor-codes  7, 0x08\n  \
                        source        ETG.1000";
        assert_eq!(ask(text, "0x2310").as_deref(), Ok(expected));
        assert_eq!(
            ask(text, "x").as_deref(),
            Ok("homing bit x of test\n\n  bits    start 4, done 0xA\n  source  ETG.1000")
        );
    }

    #[test]
    fn sections_that_nobody_knows_are_shown_all_the_same() {
        let text = "[widgets.a]\nname = \"First\"\n[widgets.-1]\nname = \"Second\"\naliases = [5]\n";
        assert_eq!(ask(text, "widgets").as_deref(), Ok("widgets of test\n  a   First\n  -1  Second"));
        for words in ["widget -1", "5", "second"] {
            assert!(
                ask(text, words).is_ok_and(|said| said.starts_with("widget -1 of test: Second")),
                "{words}"
            );
        }
        assert_eq!(ask(text, ""), Err(Unknown { near: Vec::new() }));
    }
}
