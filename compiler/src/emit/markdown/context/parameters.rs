//! The vendor's parameters: where each is described, and where a running text names one.

use std::collections::{BTreeMap, BTreeSet};

use super::Context;
use crate::emit::markdown::inline::{append, code, fragment, link, text};
use crate::model::Parameter;

/// Anchors of parameters by name.
pub(super) type Places<'a> = BTreeMap<&'a str, String>;

impl<'a> Context<'a> {
    /// The anchor of a parameter that is no object.
    pub(in crate::emit::markdown) fn parameter_id(&self, parameter: &Parameter) -> String {
        fragment(format!("parameter-{}", parameter.id))
    }

    /// A parameter by name, linked to where it is described.
    pub(in crate::emit::markdown) fn parameter(&self, name: &str) -> String {
        self.place_of(name).map_or_else(|| code(name), |place| link(code(name), place))
    }

    /// Writes a text with no numbers of objects in it, with every parameter linked that it names.
    pub(super) fn named_parameters(&self, plain: &str, out: &mut String) {
        let mut written = 0;
        let mut at = if self.initials.is_empty() { plain.len() } else { 0 };
        while let Some(run) = next_run(plain, at, |first| self.initials.contains(&first)) {
            at = run.end;
            let found = ends(run.text).find_map(|name| {
                let place = is_telling(name).then(|| self.place_of(name))??;
                Some((name, place))
            });
            if let Some((name, place)) = found {
                keep_spaces(plain.get(written..run.start).unwrap_or_default(), out);
                out.push_str(&link(text(name), place));
                written = run.start + name.len();
                at = written;
            }
        }
        keep_spaces(plain.get(written..).unwrap_or_default(), out);
    }

    /// The anchors of the parameters by name. One with elements that are entries is found without the number of an
    /// element, too.
    pub(super) fn places(&self) -> Places<'a> {
        let rows = self.device.parameters.iter();
        let mut places: Places<'a> =
            rows.map(|parameter| (parameter.id.as_str(), self.parameter_id(parameter))).collect();
        for object in self.leading_objects() {
            let entries = object.entries.iter().filter_map(|entry| entry.parameter.as_deref());
            let mut names = object.parameter.as_deref().into_iter().chain(entries).peekable();
            let Some(place) = names.peek().and_then(|_| self.anchor(object.index)) else { continue };
            for name in names.flat_map(|name| [name, whole(name)]) {
                places.entry(name).or_insert_with(|| place.clone());
            }
        }
        places
    }

    /// Where a parameter or an element of one is described, in this device or else in another of the document.
    fn place_of(&self, name: &str) -> Option<&str> {
        let place = |name: &str| self.places.get(name).or_else(|| self.shared.get(name));
        place(name).or_else(|| place(whole(name))).map(String::as_str)
    }
}

/// The anchors in the document, each of the first device that has the parameter.
pub(super) fn shared<'a>(members: &[Context<'a>]) -> Places<'a> {
    let mut shared = Places::new();
    for (name, place) in members.iter().flat_map(|member| &*member.places) {
        shared.entry(name).or_insert_with(|| place.clone());
    }
    shared
}

/// What names of parameters begin with.
pub(super) fn initials(places: &Places<'_>) -> BTreeSet<char> {
    places.keys().filter_map(|name| name.chars().next()).collect()
}

/// A parameter without the number of its element.
fn whole(name: &str) -> &str {
    name.split_once('[').map_or(name, |(whole, _)| whole)
}

/// Whether a name is one in running text, too, where `V` is a unit and `stop` a word.
fn is_telling(name: &str) -> bool {
    let is_own = |c: char| c.is_ascii_digit() || c.is_uppercase() || c == '_';
    name.contains(|c: char| c.is_ascii_digit()) || name.len() > 2 && name.chars().skip(1).any(is_own)
}

/// How far a name of a parameter goes at most: from each word on, no more of a longer run is looked at.
const LONGEST: usize = 64;

/// Signs in a row of which names of parameters are made.
struct Run<'t> {
    start: usize,
    end: usize,
    text: &'t str,
}

/// The next word of a text from a place on that begins as one is looked for, with the rest of the run that it begins.
fn next_run(plain: &str, mut from: usize, begins: impl Fn(char) -> bool) -> Option<Run<'_>> {
    let (start, rest, end) = loop {
        let start = from + plain.get(from..)?.find(is_word)?;
        let rest = plain.get(start..)?;
        let end = start + rest.find(|c| !is_word(c)).unwrap_or(rest.len());
        if rest.starts_with(&begins) {
            break (start, rest, end);
        }
        from = end;
    };
    let near = rest.char_indices().nth(LONGEST).map_or(rest, |(place, _)| rest.split_at(place).0);
    let text = match near.find(|c| !is_word(c) && !"[].-".contains(c)) {
        Some(length) => near.split_at(length).0,
        None if near.len() < rest.len() => near.trim_end_matches(is_word),
        None => near,
    };
    Some(Run { start, end, text })
}

/// What a run may begin with: the longest first, and never half a word.
fn ends(run: &str) -> impl Iterator<Item = &str> {
    let inner = run.char_indices().rev().filter_map(|(place, _)| {
        let (before, rest) = run.split_at(place);
        let cuts = before.ends_with(is_word) && rest.starts_with(is_word);
        (!cuts && !before.is_empty()).then_some(before)
    });
    [run].into_iter().chain(inner)
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Escapes, but leaves a space at either end where there is one.
fn keep_spaces(plain: &str, out: &mut String) {
    if plain.starts_with(char::is_whitespace) {
        out.push(' ');
    }
    append(plain, out);
    if plain.ends_with(char::is_whitespace) && !plain.trim_start().is_empty() {
        out.push(' ');
    }
}
