//! From ESI to a description and back.

use devc::emit::{self, Options};
use devc::import::{Choice, Imported, Note, import};

use super::facts::{self, Facts};

/// What became of the facts of a device.
#[derive(Debug)]
pub(crate) struct Trip {
    pub(crate) facts: usize,
    /// Those of mapping objects, which follow from PDOs.
    pub(crate) mappings: usize,
    /// What is not the same any more, by fact: what was there, and what is there now.
    pub(crate) changed: Vec<(String, String, Option<String>)>,
    /// Those of them that the report says nothing of.
    pub(crate) silent: Vec<String>,
    pub(crate) imported: Imported,
    pub(crate) warnings: usize,
}

/// Imports a device by its number and makes an ESI file of the description.
pub(crate) fn trip(bytes: &[u8], number: usize) -> Result<Trip, String> {
    let choice = Choice { device: Some(number.to_string()), revision: None };
    let imported = import(bytes, "drive.xml", &choice).map_err(|refusal| refusal.why)?;
    let (xml, warnings) = compiled(&imported)?;
    let text = facts::text(bytes);
    let document = roxmltree::Document::parse(&text).map_err(|error| error.to_string())?;
    let before = facts::of(facts::devices(&document)[number - 1]);
    let document = roxmltree::Document::parse(&xml).map_err(|error| error.to_string())?;
    let after = facts::of(facts::devices(&document)[0]);
    let changed = changed(&before, &after);
    let mappings = before.keys().filter(|key| is_mapping(key)).count();
    let silent = changed.iter().filter(|(key, ..)| !is_reported(&before, key, &imported));
    let silent = silent.map(|(key, was, is)| format!("{key}: {was} became {is:?}")).collect();
    Ok(Trip { facts: before.len(), mappings, changed, silent, imported, warnings })
}

/// The ESI that devc makes of the files, and how many warnings it has about them.
pub(crate) fn compiled(imported: &Imported) -> Result<(String, usize), String> {
    let compilation = devc::compile(&imported.in_memory("drive"), "drive".as_ref());
    let messages: Vec<&String> = compilation.diagnostics.iter().map(|it| &it.message).collect();
    let warnings = messages.len();
    let Some(family) = compilation.family else { return Err(format!("does not compile: {messages:?}")) };
    let files = emit::emit(&family, &[&emit::esi::Esi], &Options::default());
    Ok((files.text(".xml").expect("an ESI").to_owned(), warnings))
}

/// Whether a fact is one of a mapping object.
pub(crate) fn is_mapping(key: &str) -> bool {
    let index = key.strip_prefix("object/").and_then(|rest| u16::from_str_radix(rest.get(..4)?, 16).ok());
    index.is_some_and(|index| matches!(index, 0x1600..=0x17FF | 0x1A00..=0x1BFF))
}

/// That each of the devices of two files says the same in both.
pub(crate) fn same_devices(xml: &str, made: &str, count: usize) {
    let before = roxmltree::Document::parse(xml).expect("XML");
    let after = roxmltree::Document::parse(made).expect("XML");
    let (before, after) = (facts::devices(&before), facts::devices(&after));
    assert_eq!((before.len(), after.len()), (count, count));
    for (before, after) in before.into_iter().zip(after) {
        assert_eq!(changed(&facts::of(before), &facts::of(after)), []);
    }
}

fn changed(before: &Facts, after: &Facts) -> Vec<(String, String, Option<String>)> {
    let mut changed = Vec::new();
    for (key, fact) in before {
        let now = after.get(key).map(|fact| fact.value.clone());
        let is_same = now.as_deref().is_some_and(|now| same(key, &fact.value, now));
        if !is_same && !is_forbidden_choice(before, key) {
            changed.push((key.clone(), fact.value.clone(), now));
        }
    }
    changed
}

/// Whether it is a value of an enumeration on a type that ETG.2000 lets be none: the ESI has it in a comment.
fn is_forbidden_choice(facts: &Facts, key: &str) -> bool {
    let Some((entry, _)) = key.split_once("/choice/") else { return false };
    let Some(base) = facts.get(&format!("{entry}/type")) else { return false };
    !["BOOL", "BIT", "USINT", "UINT", "UDINT"].iter().any(|allowed| base.value.starts_with(allowed))
}

/// Names are the same whatever their case and signs, and with the axis behind them.
fn same(key: &str, one: &str, other: &str) -> bool {
    let other = match other.strip_prefix(one) {
        Some(rest) if rest.starts_with(" (") && rest.ends_with(')') => one,
        _ => other,
    };
    let letters = |text: &str| -> String {
        text.chars().filter(|char| char.is_alphanumeric()).flat_map(char::to_lowercase).collect()
    };
    one == other || key.ends_with("name") && letters(one) == letters(other)
}

/// Whether something of the part of the file that a fact stands in is reported.
fn is_reported(before: &Facts, key: &str, imported: &Imported) -> bool {
    let lines = &before[key].lines;
    let inside = |line: usize| lines.iter().any(|(first, last)| (*first..=*last).contains(&line));
    // One note for all values whose mapping follows from the PDOs.
    let is_told = |note: &Note| key.ends_with("/mapping") && note.what == "what can be mapped";
    imported.report.notes.iter().any(|note| inside(note.place.0) || is_told(note))
}
