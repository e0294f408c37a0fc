//! What an import kept, lost and guessed, each with its place in the file.

use std::collections::BTreeMap;

use super::read::{At, Unread};
use crate::text::characters;

/// What came of what a file says.
#[derive(Debug, Default)]
pub struct Report {
    /// The facts that the file states of what was imported: attributes and texts.
    pub facts: usize,
    /// What is worth telling, in the order of the file.
    pub notes: Vec<Note>,
}

/// Something that is not in the description as it is in the file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Note {
    /// Whether it is lost or guessed.
    pub kind: NoteKind,
    /// Where it stands in the file: the line and the column of its element.
    pub place: (usize, usize),
    /// What it is: a place in the tree of the file, such as `RxPdo/@Su`, or a thing by its index.
    pub what: String,
    /// What the file says there, where that is short.
    pub says: String,
    /// Why, or what was taken instead.
    pub why: String,
    /// How many facts are lost by it.
    pub facts: usize,
    pub(super) at: At,
}

/// What became of a fact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum NoteKind {
    /// The description does not say it.
    Lost,
    /// The description says what the file leaves open or says otherwise.
    Guessed,
}

impl NoteKind {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Lost => "lost",
            Self::Guessed => "guessed",
        }
    }
}

impl Report {
    pub(super) fn lose(&mut self, at: At, facts: usize, what: impl Into<String>, why: impl Into<String>) {
        self.note(NoteKind::Lost, at, facts, what.into(), why.into());
    }

    pub(super) fn guess(&mut self, at: At, what: impl Into<String>, why: impl Into<String>) {
        self.note(NoteKind::Guessed, at, 0, what.into(), why.into());
    }

    fn note(&mut self, kind: NoteKind, at: At, facts: usize, what: String, why: String) {
        self.notes.push(Note { kind, place: (0, 0), what, says: String::new(), why, facts, at });
    }

    /// What was guessed since there were so many notes, each thing once, in words for a comment.
    pub(super) fn guessed_since(&self, notes: usize) -> Vec<String> {
        let mut guessed: Vec<String> = Vec::new();
        for note in self.notes.iter().skip(notes).filter(|note| note.kind == NoteKind::Guessed) {
            let words = characters::line(&format!("{}: {}", note.what, note.why)).into_owned();
            if guessed.last() != Some(&words) {
                guessed.push(words);
            }
        }
        guessed
    }

    /// Reports what nobody read.
    pub(super) fn unread(&mut self, unread: Vec<Unread>) {
        for Unread { path, at, value, facts } in unread {
            let (kind, why) = (NoteKind::Lost, reason(&path).to_owned());
            self.notes.push(Note {
                kind,
                place: (0, 0),
                what: path,
                says: shortened(&value),
                why,
                facts,
                at,
            });
        }
    }

    /// How many facts are lost.
    pub fn lost(&self) -> usize {
        self.notes.iter().map(|note| note.facts).sum::<usize>().min(self.facts)
    }

    /// Puts the notes in order and finds their lines.
    pub(super) fn finish(&mut self, text: &str) {
        self.notes.sort_by_key(|note| note.at);
        let (mut line, mut column, mut done) = (1, 1, 0);
        for note in &mut self.notes {
            let passed = text.get(done..note.at.0).unwrap_or_default();
            let (lines, rest) = passed
                .rsplit_once('\n')
                .map_or((0, None), |(before, rest)| (before.matches('\n').count() + 1, Some(rest)));
            line += lines;
            column = rest.map_or(column, |_| 1) + rest.unwrap_or(passed).chars().count();
            done = done.max(note.at.0);
            note.place = (line, column);
        }
    }

    /// For people: what is alike in one line, with the first place.
    pub fn text(&self, file: &str) -> String {
        let mut alike: BTreeMap<(NoteKind, &str, &str), (usize, usize, &Note)> = BTreeMap::new();
        for note in &self.notes {
            let known = alike.entry((note.kind, &note.what, &note.why)).or_insert((0, 0, note));
            known.0 += 1;
            known.1 += note.facts;
        }
        let kept = self.facts - self.lost();
        let mut text = format!("{file}: {kept} of {} facts kept\n", self.facts);
        for ((kind, what, why), (times, facts, first)) in alike {
            let (line, column) = first.place;
            let times = match times {
                1 if facts > 1 => format!(", {facts} facts"),
                1 if first.says.is_empty() => String::new(),
                1 => format!(", `{}`", first.says),
                _ if facts > times => format!(", {times} times with {facts} facts"),
                _ => format!(", {times} times"),
            };
            let said = format!("{}: {what}{times}, at {line}:{column}: {why}", kind.name());
            text.push_str("  ");
            text.push_str(&characters::line(&said));
            text.push('\n');
        }
        text
    }

    /// For tools.
    #[cfg(feature = "json")]
    pub fn json(&self, file: &str) -> String {
        let notes = self.notes.iter().map(|note| {
            serde_json::json!({
                "kind": note.kind.name(),
                "line": note.place.0,
                "column": note.place.1,
                "what": note.what,
                "says": note.says,
                "why": note.why,
                "facts": note.facts,
            })
        });
        let lost = self.lost();
        let report = serde_json::json!({
            "file": file,
            "facts": self.facts,
            "kept": self.facts - lost,
            "lost": lost,
            "notes": notes.collect::<Vec<_>>(),
        });
        characters::json(&format!("{report:#}\n")).into_owned()
    }
}

/// Why nobody reads an element or a key.
fn reason(path: &str) -> &'static str {
    let parent = path.split('/').next();
    match path.rsplit('/').next() {
        _ if matches!(parent, Some("VendorSpecific" | "TwinCAT")) => "it is for the tools of one vendor",
        Some("VendorSpecific") => "it is for the tools of one vendor",
        Some("DictionaryFile") => "it is in another file, and no other file is read",
        Some("Slots") => "it is open which modules are in them",
        Some(key) if key.to_ascii_lowercase().ends_with("parametervalue") => {
            "it is what one node was set up with"
        }
        Some("@LcId") => "no text is in English; this one is taken for it",
        Some("DefaultData" | "MinData" | "MaxData") => "it is not bytes in hexadecimal of one value",
        _ => "descriptions have no place for it",
    }
}

/// The beginning of a text that is too long for a line.
pub(super) fn shortened(text: &str) -> String {
    const MOST: usize = 40;
    if text.chars().count() <= MOST {
        text.to_owned()
    } else {
        text.chars().take(MOST).chain(['…']).collect()
    }
}
