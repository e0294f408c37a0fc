//! What fits where one is writing.

use std::ops::Range;

use super::Knowledge;
use super::spot::plain;
use super::thing::{Thing, of};
use crate::model::Section;
use crate::profiles;
use crate::reference::Shape;
use crate::reference::relation::{Names, names};
use crate::rules;
use crate::source::Member;
use crate::written::{Cursor, Slot, word};

/// Something that can be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Completion {
    /// What is shown in the list.
    pub label: String,
    /// What is written in place of `replaces`.
    pub text: String,
    /// The bytes of the text that it takes the place of.
    pub replaces: Range<usize>,
    /// What it is, in a line.
    pub detail: String,
    /// What it means.
    pub about: String,
    /// Whether it is a key, and not a value.
    pub is_key: bool,
}

/// All that can be written at a byte of a text. Within a character that is before it, and behind the end at the end.
pub fn complete(text: &str, offset: usize, knowledge: Option<&Knowledge>) -> Vec<Completion> {
    complete_beside(text, offset, knowledge, &|_| Vec::new())
}

/// All that can be written at a byte of the text of a file, whose neighbours can be named: `list` has the names in a folder
/// that is written as the file would write it, those of folders with a slash behind them.
pub fn complete_beside(
    text: &str,
    offset: usize,
    knowledge: Option<&Knowledge>,
    list: &dyn Fn(&str) -> Vec<String>,
) -> Vec<Completion> {
    let offset = (0..=offset.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or_default();
    let cursor = Cursor::at(text, offset);
    let before = text.get(..offset).unwrap_or(text);
    let start = before.len() - word(before).len();
    let site = Site { cursor: &cursor, knowledge, list, text, word: word(before), replaces: start..offset };
    match &cursor.slot {
        Slot::Prose => Vec::new(),
        Slot::Header | Slot::Key => site.keys(),
        Slot::Value(key) => site.values(key),
    }
}

/// Where something is written.
struct Site<'a> {
    cursor: &'a Cursor,
    knowledge: Option<&'a Knowledge>,
    list: &'a dyn Fn(&str) -> Vec<String>,
    text: &'a str,
    word: &'a str,
    replaces: Range<usize>,
}

/// The types that values can have.
const TYPES: &[&str] = &[
    "BOOL", "INT8", "INT16", "INT32", "INT64", "UINT8", "UINT16", "UINT32", "UINT64", "REAL32", "REAL64",
    "BYTE", "WORD", "DWORD", "BIT1", "BIT2", "BIT3", "BIT4", "BIT5", "BIT6", "BIT7", "BIT8", "STRING",
];

impl Site<'_> {
    fn key(&self, key: &str, detail: String, about: String) -> Completion {
        let is_bare = key.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '-' | '_'));
        let text = if is_bare { key.to_owned() } else { format!("\"{key}\"") };
        Completion {
            label: key.to_owned(),
            text,
            replaces: self.replaces.clone(),
            detail,
            about,
            is_key: true,
        }
    }

    /// A value; a string takes the place of its closing quote as well.
    fn value(&self, label: &str, written: String, detail: String, about: String) -> Completion {
        let mut replaces = self.replaces.clone();
        let quote = self.word.chars().next().filter(|c| matches!(c, '"' | '\''));
        let rest = self.text.get(replaces.end..).unwrap_or_default();
        let line = rest.split('\n').next().unwrap_or_default();
        let is_tail = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | ':' | '.' | '/');
        let tail = line.len() - line.trim_start_matches(is_tail).len();
        if let Some(quote) = quote
            && line.get(tail..).is_some_and(|rest| rest.starts_with(quote))
        {
            replaces.end += tail + 1;
        }
        Completion { label: label.to_owned(), text: written, replaces, detail, about, is_key: false }
    }

    fn keys(&self) -> Vec<Completion> {
        let around: Vec<&str> = self.cursor.around.iter().map(String::as_str).collect();
        let shape = Shape::find(around.iter().copied());
        let known = shape.map(Shape::keys).unwrap_or_default();
        let is_header = self.cursor.slot == Slot::Header;
        let known = known.into_iter().filter(|(key, shape)| {
            let holds_tables = shape.is("object") || shape.is("array");
            (!is_header || holds_tables) && !self.cursor.siblings.iter().any(|sibling| sibling == key)
        });
        let known = known.map(|(key, shape)| self.key(key, kind(shape).to_owned(), shape.about().to_owned()));
        known.chain(self.of_profile()).chain(self.axes()).collect()
    }

    /// The keys that profiles have at this place and the description has not yet.
    fn of_profile(&self) -> Vec<Completion> {
        let path = plain(&self.cursor.around);
        let Some(knowledge) = self.knowledge.filter(|_| !path.is_empty()) else { return Vec::new() };
        let table = knowledge.in_profile(&path).and_then(|member| member.node.table());
        let members = table.map_or(&[][..], |table| &table.members);
        let is_named =
            |member: &&Member| Shape::find(path.iter().copied().chain([&*member.key.name])).is_some();
        let is_closed = Shape::find(path.iter().copied()).is_some_and(|shape| !shape.keys().is_empty());
        let is_new = |member: &&Member| {
            let own = knowledge.in_description(&path).and_then(|own| own.node.table());
            let is_there = own.is_some_and(|own| own.get(&member.key.name).is_some());
            let is_sibling = self.cursor.siblings.contains(&member.key.name.to_string());
            !is_sibling && (self.cursor.slot == Slot::Header || !is_there || path.len() > 1)
        };
        let members = members.iter().filter(|member| !is_closed && is_named(member)).filter(is_new);
        members.map(|member| self.of_member(member)).collect()
    }

    fn of_member(&self, member: &Member) -> Completion {
        let table = member.node.table();
        let text = |key: &str| table.and_then(|table| super::thing::text(table, key)).unwrap_or_default();
        let name = match &member.node.value {
            crate::source::Value::String(name) => name.to_string(),
            _ => text("name").to_owned(),
        };
        self.key(&member.key.name, name, text("about").to_owned())
    }

    /// The axes, where keys are their names.
    fn axes(&self) -> Vec<Completion> {
        let is_axes = self.cursor.around.last().is_some_and(|key| key == "per-axis");
        let Some(knowledge) = self.knowledge.filter(|_| is_axes) else { return Vec::new() };
        let names = knowledge.in_description(&["axes", "names"]).map(|member| &member.node.value);
        let Some(crate::source::Value::Array(names)) = names else { return Vec::new() };
        let names = names.iter().filter_map(|node| match &node.value {
            crate::source::Value::String(name) => Some(self.key(name, "an axis".to_owned(), String::new())),
            _ => None,
        });
        names.collect()
    }

    fn values(&self, key: &str) -> Vec<Completion> {
        let path: Vec<&str> = self.cursor.around.iter().map(String::as_str).chain([key]).collect();
        let choices = Shape::find(path.iter().copied()).map(Shape::choices).unwrap_or_default();
        let mut values: Vec<Completion> = Vec::new();
        for choice in choices {
            let label = choice.written.trim_matches('"').to_owned();
            values.push(self.value(&label, choice.written, String::new(), choice.about));
        }
        let mut plain = plain(&self.cursor.around);
        plain.push(key);
        if let Some(names) = names(&plain) {
            values.extend(self.named(names, plain.first().copied().unwrap_or_default()));
            if names == Names::Files {
                values.extend(self.files(key));
            }
        }
        values
    }

    fn named(&self, names: Names, section: &str) -> Vec<Completion> {
        let quoted = |word: &str, detail: &str| {
            self.value(word, format!("\"{word}\""), detail.to_owned(), String::new())
        };
        match names {
            Names::Types => TYPES.iter().map(|word| quoted(word, "")).collect(),
            Names::Profiles => profiles::ALL.iter().map(|it| quoted(it.name, "a profile")).collect(),
            Names::Rules => rules::all().iter().map(|rule| quoted(rule.name, rule.summary)).collect(),
            Names::Files => Vec::new(),
            _ => self.knowledge.map(|knowledge| self.things(knowledge, names, section)).unwrap_or_default(),
        }
    }

    /// The files beside this one, and those in the folder that is being written.
    fn files(&self, key: &str) -> Vec<Completion> {
        let end = if key == "include" { ".toml" } else { ".bmp" };
        let begun = self.word.trim_start_matches(['"', '\'']);
        let folder = begun.rfind('/').and_then(|place| begun.get(..=place)).unwrap_or_default();
        let fits = |name: &String| (name.ends_with(end) || name.ends_with('/')) && !self.is_named(name);
        let names = (self.list)(folder).into_iter().filter(fits);
        names
            .map(|name| {
                let (path, detail) =
                    (format!("{folder}{name}"), if name.ends_with('/') { "a folder" } else { "a file" });
                self.value(&path, format!("\"{path}\""), detail.to_owned(), String::new())
            })
            .collect()
    }

    /// Whether the text names a file already.
    fn is_named(&self, name: &str) -> bool {
        let mut named = ["\"", "'"].into_iter().map(|quote| format!("{quote}{name}{quote}"));
        named.any(|quoted| self.text.contains(&quoted))
    }

    fn things(&self, knowledge: &Knowledge, names: Names, section: &str) -> Vec<Completion> {
        match names {
            Names::Objects => self.objects(knowledge),
            Names::Things(sections) => sections
                .iter()
                .flat_map(|section| knowledge.things(*section))
                .map(|it| self.thing(&it))
                .collect(),
            Names::Siblings => {
                let section = Section::find(section);
                let things = section.into_iter().flat_map(|section| of(&knowledge.root, section));
                things.map(|thing| self.thing(&thing)).collect()
            }
            Names::Documents => {
                let documents = knowledge.things(Section::Documents);
                let open = |it: Thing<'_>| {
                    let (key, text) = (it.key(), format!("\"{}: \"", it.key()));
                    self.value(key, text, it.title(), String::new())
                };
                documents.map(open).collect()
            }
            Names::Places => self.objects(knowledge),
            Names::Rules | Names::Profiles | Names::Files | Names::Types => Vec::new(),
        }
    }

    /// A thing by its key, which is a number where the format has one.
    fn thing(&self, thing: &Thing<'_>) -> Completion {
        let is_number = crate::source::keys::number(thing.key()).is_some() && !thing.key().starts_with("0x");
        let text = if is_number { thing.key().to_owned() } else { format!("\"{}\"", thing.key()) };
        self.value(thing.key(), text, thing.title(), thing.text("about").unwrap_or_default().to_owned())
    }

    /// Objects and their entries: by index if one has begun to write one, by their word else.
    fn objects(&self, knowledge: &Knowledge) -> Vec<Completion> {
        let by_index = self.word.trim_start_matches(['"', '\'']).starts_with("0x");
        let mut values = Vec::new();
        for thing in knowledge.things(Section::Objects) {
            let id = if by_index { thing.key().to_owned() } else { thing.id() };
            let detail = format!("{} {}", thing.key(), thing.title());
            let about = thing.text("about").unwrap_or_default();
            values.push(self.value(&id, format!("\"{id}\""), detail, about.to_owned()));
            for entry in thing.entries() {
                let Some(subindex) = crate::source::keys::number(&entry.key.name).filter(|it| *it > 0) else {
                    continue;
                };
                let label = format!("{id}:{subindex:02X}");
                let name = entry.node.table().and_then(|table| super::thing::text(table, "name"));
                let detail = format!("{}:{subindex:02X} {}", thing.key(), name.unwrap_or_default());
                values.push(self.value(&label, format!("\"{label}\""), detail, String::new()));
            }
        }
        values
    }
}

/// What a key holds, in a word.
fn kind(shape: Shape) -> &'static str {
    let kinds = [
        ("object", "table"),
        ("array", "list"),
        ("boolean", "true or false"),
        ("integer", "whole number"),
        ("number", "number"),
        ("string", "text"),
    ];
    kinds.iter().find(|(kind, _)| shape.is(kind)).map_or("", |(_, word)| word)
}

#[cfg(test)]
mod tests {
    use super::complete;

    #[test]
    fn what_is_replaced_lies_in_the_text() {
        for (text, offset) in [("é", 1), ("", 3), ("[device]\nna", 400)] {
            let completions = complete(text, offset, None);
            assert!(!completions.is_empty(), "{text:?} at {offset}");
            for it in completions {
                assert!(text.get(it.replaces.clone()).is_some(), "{text:?} at {offset}: {it:?}");
            }
        }
    }
}
