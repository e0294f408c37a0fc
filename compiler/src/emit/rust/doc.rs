//! Doc comments.

use std::fmt::Display;

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, TokenStreamExt, quote};

use super::literal;
use crate::model::{Device, Pdo, Provenance, Source, facts, facts_of_type};
use crate::source::Origin;

/// Columns of a line of documentation.
const WIDTH: usize = 100;

/// The documentation of an item: a title, then paragraphs.
#[derive(Debug, Clone, Default)]
pub(super) struct Doc {
    lines: Vec<String>,
}

impl Doc {
    /// Documentation that begins with a line, in Markdown.
    pub(super) fn new(title: impl AsRef<str>) -> Self {
        Self::default().text(title.as_ref())
    }

    /// Whether it says nothing.
    pub(super) fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }

    /// Another paragraph, in Markdown.
    pub(super) fn text(mut self, text: &str) -> Self {
        if text.is_empty() {
            return self;
        }
        if !self.lines.is_empty() {
            self.lines.push(String::new());
        }
        wrap(text, &mut self.lines);
        self
    }

    /// Another paragraph, if there is one, of plain text.
    pub(super) fn maybe(self, text: Option<&str>) -> Self {
        match text {
            Some(text) => self.text(&escape(text)),
            None => self,
        }
    }

    /// Lines as they are, such as those of a table.
    pub(super) fn lines(mut self, lines: impl IntoIterator<Item = String>) -> Self {
        self.lines.push(String::new());
        self.lines.extend(lines);
        self
    }

    /// Where the facts are from, if that is known: at the end of the title.
    pub(super) fn source(mut self, source: Option<&Source>, device: &Device) -> Self {
        let Some(source) = source else { return self };
        if self.is_empty() {
            return self.text(&format!("Source: {}.", escape(&place(source, device))));
        }
        let rest = self.lines.iter().position(String::is_empty).unwrap_or(self.lines.len());
        let rest = self.lines.split_off(rest);
        let title = self.lines.join(" ");
        let title = title.strip_suffix('.').unwrap_or(&title);
        let mut doc = Self::new(format!("{title} ({}).", escape(&place(source, device))));
        doc.lines.extend(rest);
        doc
    }

    /// Where the facts are from, and a sentence for each that is not from there: assumed, corrected, contradicted.
    pub(super) fn said(self, source: Option<&Source>, origin: &Origin, device: &Device) -> Self {
        let departures = departures(origin, facts_of_type(origin), device);
        self.source(source, device).sentences(departures.into_iter())
    }

    /// A sentence for each of these keys that no source states as it stands here; for constants that are made of a part of
    /// what a table says.
    pub(super) fn departing(self, keys: &[&str], origin: &Origin, device: &Device) -> Self {
        self.sentences(departures_of(keys, origin, device).into_iter())
    }

    /// A paragraph with such sentences for a row of a table, which has no documentation of its own.
    pub(super) fn of_row(self, row: impl Display, keys: &[&str], origin: &Origin, device: &Device) -> Self {
        let departures = departures_of(keys, origin, device);
        match departures.is_empty() {
            true => self,
            false => self.text(&format!("*{row}*: {}", escape(&departures.join(" ")))),
        }
    }

    /// A sentence for each reason, or erratum, for what a PDO carries: its type, which members of a family share, tells
    /// only the rest.
    pub(super) fn carrying(self, pdo: &Pdo, device: &Device) -> Self {
        let facts = facts(&pdo.origin).into_iter().filter(|(path, _)| path == "entries");
        let path = format!("entries of {}", pdo.index);
        self.sentences(facts.filter_map(|(_, who)| departure(&path, &who, device)))
    }

    /// Another paragraph, of these sentences, if there are any.
    pub(super) fn sentences(self, sentences: impl Iterator<Item = String>) -> Self {
        let sentences: Vec<String> = sentences.collect();
        self.text(&escape(&sentences.join(" ")))
    }

    /// The documentation of the module that it stands in.
    pub(super) fn inner(&self) -> TokenStream {
        let text = self.literal().into_iter();
        quote!(#(#![doc = #text])*)
    }

    /// All lines as `///` has them, as one literal, if there are any.
    fn literal(&self) -> Option<Literal> {
        let mut text = String::with_capacity(self.lines.iter().map(|line| line.len() + 2).sum());
        for (number, line) in self.lines.iter().enumerate() {
            text.push_str(if number > 0 { "\n" } else { "" });
            text.push_str(if line.is_empty() { "" } else { " " });
            text.push_str(line);
        }
        (!self.lines.is_empty()).then(|| literal::text(&text))
    }
}

impl ToTokens for Doc {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        let text = self.literal().into_iter();
        tokens.append_all(quote!(#(#[doc = #text])*));
    }
}

/// A sentence for each of these keys that no source states as it stands here.
fn departures_of(keys: &[&str], origin: &Origin, device: &Device) -> Vec<String> {
    let mut facts = facts(origin);
    facts.retain(|(path, _)| keys.contains(&path.as_str()));
    departures(origin, facts, device)
}

/// A sentence for each reason, or erratum, for facts of a table that the source does not state as they stand here.
pub(super) fn departures(origin: &Origin, facts: Vec<(String, Provenance)>, device: &Device) -> Vec<String> {
    let all = facts.len();
    let mut departures: Vec<(Provenance, Vec<String>)> = Vec::new();
    for (path, who) in facts {
        match departures.iter_mut().find(|(other, _)| *other == who) {
            Some((_, paths)) => paths.push(path),
            None => departures.push((who, vec![path])),
        }
    }
    let has_one_reason = origin.node("assumed").is_some_and(|reasons| reasons.table().is_none());
    let told = departures.iter().filter_map(|(who, paths)| {
        let is_all = has_one_reason && paths.len() == all;
        let paths: Vec<String> = paths.iter().map(|path| spoken(path)).collect();
        departure(&if is_all { String::new() } else { paths.join(", ") }, who, device)
    });
    told.collect()
}

/// A path as people say it: what is mapped in a PDO is counted as in its mapping object.
fn spoken(path: &str) -> String {
    let mapped = path.strip_prefix("entries.").and_then(|path| path.split_once('.'));
    let mapped = mapped.and_then(|(place, key)| Some((place.parse::<u8>().ok()?.checked_add(1)?, key)));
    mapped.map_or_else(|| path.to_owned(), |(place, key)| format!("{key} of {place}"))
}

/// What a line says of a fact that the source does not state as it stands here.
pub(super) fn departure(path: &str, who: &Provenance, device: &Device) -> Option<String> {
    let path = if path.is_empty() { String::new() } else { format!(", {path}") };
    let erratum = |number: &u16| device.errata.get(usize::from(*number));
    match who {
        Provenance::Assumed(reason) => Some(format!("Assumed{path}: {reason}.")),
        Provenance::Corrected(number) => {
            let erratum = erratum(number)?;
            Some(format!("Corrected{path}; the source says: {}. {}", erratum.says, erratum.why))
        }
        Provenance::Contradicted(number) => Some(format!("Contradicted{path}: {}", erratum(number)?.why)),
        Provenance::Stated | Provenance::Profile | Provenance::Derived => None,
    }
}

/// The place, with the document's number if it is not the main one.
pub(super) fn place(source: &Source, device: &Device) -> String {
    let named =
        source.document.as_ref().and_then(|id| device.documents.iter().find(|document| document.id == *id));
    match (named, device.documents.first()) {
        (Some(document), Some(main)) if document.id != main.id => {
            format!("{}, {}", document.number.as_ref().unwrap_or(&document.title), source.place)
        }
        _ => source.place.clone(),
    }
}

/// Plain text in which nothing is taken for Markdown.
pub(super) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len() + text.len() / 8);
    let is_markup = |_, byte| matches!(byte, b'[' | b']' | b'<' | b'>' | b'*' | b'`' | b'_');
    crate::emit::escape::escape(text, is_markup, &mut escaped);
    escaped
}

/// A name as the beginning of a sentence, with a full stop. A code such as `n17` stays as it is written.
pub(super) fn sentence(text: &str) -> String {
    let text = text.trim();
    let is_code =
        text.split_whitespace().next().is_some_and(|word| word.contains(|c: char| c.is_ascii_digit()));
    let mut chars = text.chars();
    let first = chars.next().map(|c| if is_code { c.to_string() } else { c.to_uppercase().to_string() });
    let first = first.unwrap_or_default();
    let stop = if text.ends_with(['.', '!', '?']) { "" } else { "." };
    escape(&format!("{first}{}{stop}", chars.as_str()))
}

fn wrap(text: &str, lines: &mut Vec<String>) {
    let (mut line, mut columns) = (String::with_capacity(text.len().min(WIDTH)), 0);
    for word in text.split_whitespace() {
        let width = word.chars().count();
        if columns > 0 && columns + 1 + width > WIDTH {
            lines.push(std::mem::take(&mut line));
            columns = 0;
        }
        if columns > 0 {
            line.push(' ');
            columns += 1;
        }
        line.push_str(word);
        columns += width;
    }
    lines.push(line);
}
