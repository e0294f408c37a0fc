//! Another word for a thing, in all files of a description.

use std::ops::Range;

use super::edit::{Refusal, Renaming, inner};
use super::spot::{Spot, all};
use super::{Knowledge, axis_name};
use crate::model::{Section, Shape};
use crate::reference::relation::{Names, names};
use crate::source::keys::number;

/// What is to be renamed: a thing of a section by its key, or an object by its id.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Name {
    section: Section,
    word: String,
}

/// The word that can be renamed at a byte of a text, with its place.
///
/// # Errors
/// If there is a word that cannot be renamed.
pub fn name_at(
    text: &str,
    offset: usize,
    knowledge: Option<&Knowledge>,
) -> Result<Option<(Range<usize>, String)>, Refusal> {
    let Some(spot) = Spot::at(text, offset) else { return Ok(None) };
    if let Some(axis) = axis_name::named(&spot) {
        return Ok(inner(&spot, text, axis).map(|at| (at, axis.to_owned())));
    }
    let Some(name) = name(&spot, knowledge)? else { return Ok(None) };
    Ok(inner(&spot, text, &name.word).map(|at| (at, name.word)))
}

/// The edits that give the word at a byte of a text another form, for each of the texts of the description.
///
/// # Errors
/// If the word cannot be renamed, or the new one cannot be its name.
pub fn rename(
    text: &str,
    offset: usize,
    new: &str,
    files: &[&str],
    knowledge: Option<&Knowledge>,
) -> Result<Vec<Renaming>, Refusal> {
    let nothing = || Refusal("there is no id here".to_owned());
    let spot = Spot::at(text, offset).ok_or_else(nothing)?;
    if let Some(axis) = axis_name::named(&spot) {
        return axis_name::rename(axis, new, files);
    }
    let name = name(&spot, knowledge)?.ok_or_else(nothing)?;
    let is_word = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_');
    if new.is_empty() || !new.chars().all(is_word) || number(new).is_some() {
        return Err(Refusal(format!("`{new}` is no id: letters, digits and dashes")));
    }
    if knowledge.is_some_and(|knowledge| knowledge.find(name.section, new).is_some()) {
        return Err(Refusal(format!("`{new}` is another one of `[{}]`", name.section.name())));
    }
    Ok(files.iter().map(|text| edits(text, &name, new, knowledge)).collect())
}

/// What a spot names, if that is something that the description named.
fn name(spot: &Spot, knowledge: Option<&Knowledge>) -> Result<Option<Name>, Refusal> {
    let path = spot.plain();
    let found = match (&spot.text, path.as_slice()) {
        (None, [section, word]) => Section::find(section).map(|section| (section, (*word).to_owned())),
        (Some(word), ["objects", _, "id"]) => Some((Section::Objects, word.clone())),
        (Some(word), _) => names(&path).and_then(|names| {
            let thing = knowledge?.named(names, path.first()?, word)?;
            let word = if thing.section == Section::Objects { thing.id() } else { thing.key().to_owned() };
            Some((thing.section, word))
        }),
        (None, _) => None,
    };
    let Some((section, word)) = found else { return Ok(None) };
    let is_id = section == Section::Objects || section.shape() == Shape::Words;
    if !is_id || number(&word).is_some() {
        return Ok(None);
    }
    let Some(knowledge) = knowledge else { return Err(Refusal("the description cannot be read".to_owned())) };
    let of_profile = super::thing::of(&knowledge.profile, section).any(|thing| thing.is(&word));
    if of_profile {
        return Err(Refusal(format!("`{word}` is what a profile calls it")));
    }
    let is_given = knowledge.find(section, &word).is_some_and(|thing| thing.text("id").is_some());
    if section == Section::Objects && !is_given {
        return Err(Refusal(format!("`{word}` is made of the object's name: give it an `id` first")));
    }
    Ok(Some(Name { section, word }))
}

fn edits(text: &str, name: &Name, new: &str, knowledge: Option<&Knowledge>) -> Renaming {
    let mut edits = Vec::new();
    all(text, &mut |spot| {
        if is_about(&spot, name, knowledge)
            && let Some(at) = inner(&spot, text, &name.word)
        {
            edits.push((at, new.to_owned()));
        }
    });
    edits
}

/// Whether a spot is the name of a thing, or names it.
fn is_about(spot: &Spot, name: &Name, knowledge: Option<&Knowledge>) -> bool {
    let path = spot.plain();
    let Some(text) = &spot.text else {
        let is_key = path.len() == 2 && path.last() == Some(&name.word.as_str());
        let section = path.first().and_then(|section| Section::find(section));
        // a word that does not say whose bits it has is called as its object is
        let is_word = name.section == Section::Objects && section == Some(Section::Words) && {
            let named = knowledge.and_then(|knowledge| knowledge.in_description(&path));
            named.is_none_or(|word| word.node.table().is_none_or(|word| word.get("object").is_none()))
        };
        return is_key && (section == Some(name.section) && name.section != Section::Objects || is_word);
    };
    if let (Section::Objects, ["objects", _, "id"]) = (name.section, path.as_slice()) {
        return *text == name.word;
    }
    let is_first = |end: &str| {
        text.strip_prefix(&name.word).is_some_and(|rest| rest.is_empty() || rest.starts_with(end))
    };
    match names(&path) {
        Some(Names::Objects) => name.section == Section::Objects && is_first(":"),
        Some(Names::Things(sections)) => sections.contains(&name.section) && *text == name.word,
        Some(Names::Siblings) => path.first() == Some(&name.section.name()) && *text == name.word,
        Some(Names::Documents) => name.section == Section::Documents && is_first(": ") && text.contains(": "),
        Some(Names::Places) => {
            let rest = text.strip_prefix(name.section.name()).and_then(|rest| rest.strip_prefix('.'));
            rest.is_some_and(|rest| rest.split('.').next() == Some(&name.word))
        }
        _ => path.last() == Some(&"without") && is_path_to(text, name),
    }
}

fn is_path_to(text: &str, name: &Name) -> bool {
    let mut parts = text.split('.');
    parts.next() == Some(name.section.name()) && parts.next() == Some(&name.word)
}
