//! What something is.

use std::ops::Range;

use super::Knowledge;
use super::spot::Spot;
use super::thing::Thing;
use crate::explain::{explain, explain_thing};
use crate::model::Section;
use crate::reference::Shape;
use crate::reference::relation::{Names, names};
use crate::source::keys::number;
use crate::source::{Layer, Member};

/// What there is to know of a key or a value, in Markdown.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hover {
    /// Where it stands, in bytes.
    pub at: Range<usize>,
    /// What it is.
    pub text: String,
}

/// What stands at a byte of a text.
pub fn hover(text: &str, offset: usize, knowledge: Option<&Knowledge>) -> Option<Hover> {
    let spot = Spot::at(text, offset)?;
    let parts = match &spot.text {
        None => of_key(&spot, knowledge),
        Some(word) => of_value(&spot, word, knowledge),
    };
    let parts: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    (!parts.is_empty()).then(|| Hover { at: spot.at, text: parts.join("\n\n") })
}

/// A key: what the format says of it, what it stands for, and who says what it is set to.
fn of_key(spot: &Spot, knowledge: Option<&Knowledge>) -> Vec<String> {
    let path = spot.plain();
    let full: Vec<&str> = spot.path.iter().map(String::as_str).collect();
    let mut parts = Vec::new();
    let (Some(key), around) = (full.last(), full.get(..full.len().saturating_sub(1)).unwrap_or_default())
    else {
        return parts;
    };
    let known = Shape::find(around.iter().copied()).map(Shape::keys).unwrap_or_default();
    if let Some((_, shape)) = known.iter().find(|(known, _)| known == key) {
        parts.push(format!("`{key}`: {}", shape.about()));
        let choices = shape.choices();
        let choices = choices.iter().filter(|choice| !choice.about.is_empty());
        let lines: Vec<String> = choices.map(|it| format!("- `{}`: {}", it.written, it.about)).collect();
        parts.push(lines.join("\n"));
    } else if let Some(shape) = Shape::find(full.iter().copied()) {
        parts.push(shape.about().to_owned());
    }
    if let Some(knowledge) = knowledge {
        parts.extend(knowledge.thing_at(&path));
        parts.extend(knowledge.origin(&path));
    }
    parts
}

fn of_value(spot: &Spot, word: &str, knowledge: Option<&Knowledge>) -> Vec<String> {
    let path = spot.plain();
    let full = spot.path.iter().map(String::as_str);
    let choices = Shape::find(full).map(Shape::choices).unwrap_or_default();
    let chosen = choices.iter().find(|choice| choice.written.trim_matches('"') == word);
    let mut parts: Vec<String> =
        chosen.map(|choice| format!("`{}`: {}", choice.written, choice.about)).into_iter().collect();
    let section = path.first().copied().unwrap_or_default();
    match (names(&path), knowledge) {
        (Some(Names::Rules | Names::Profiles), _) => {
            parts.extend(explain(&[word.to_owned()]).ok().map(|text| fenced(&text)));
        }
        (Some(names), Some(knowledge)) => {
            let entry =
                word.split_once(':').and_then(|(_, entry)| i64::from_str_radix(entry.trim(), 16).ok());
            let entry = entry.filter(|_| matches!(names, Names::Objects | Names::Places));
            let thing = knowledge.named(names, section, word);
            parts.extend(thing.and_then(|thing| knowledge.explain(thing, entry)));
        }
        _ => {}
    }
    if let Some(knowledge) = knowledge {
        parts.extend(knowledge.origin(&path));
    }
    parts
}

impl Knowledge {
    /// What is known of the thing, or the entry of it, whose key a path ends with.
    fn thing_at(&self, path: &[&str]) -> Option<String> {
        let (section, key, entry) = match path {
            [section, key] => (*section, *key, None),
            [section @ "objects", key, "entries", entry] => (*section, *key, Some(number(entry)?)),
            _ => return self.part_at(path),
        };
        let thing = self.find(Section::find(section)?, key)?;
        self.explain(thing, entry)
    }

    /// What is known of a bit or a value whose key a path ends with.
    fn part_at(&self, path: &[&str]) -> Option<String> {
        let member = self.in_description(path).filter(|_| path.len() > 3)?;
        let says = |key: &str| member.node.table().and_then(|table| super::thing::text(table, key));
        let name = match &member.node.value {
            crate::source::Value::String(name) => Some(&**name),
            _ => says("name"),
        };
        let parts = [name.map(|name| format!("**{name}**")), says("about").map(str::to_owned)];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        (!parts.is_empty()).then(|| parts.join("\n\n"))
    }

    fn explain(&self, thing: Thing<'_>, entry: Option<i64>) -> Option<String> {
        let section = thing.section.name();
        let of = |root| explain_thing("this description", root, &self.sources, section, thing.key(), entry);
        let text = of(&self.root).or_else(|| {
            let profile = crate::profiles::ALL.iter().find(|profile| {
                self.sources.get(thing.member.key.at.file).is_some_and(|file| file.text == profile.text)
            });
            let name = profile.map_or("a profile", |profile| profile.name);
            explain_thing(name, &self.profile, &self.sources, section, thing.key(), entry)
        });
        text.map(|text| fenced(&text))
    }

    /// Who set the value at a path, and where that is from.
    fn origin(&self, path: &[&str]) -> Option<String> {
        let member = self.in_description(path).filter(|_| path.len() > 2)?;
        let profile = |member: &Member| self.sources.get(member.node.at.file).map(|file| file.path.clone());
        let mut said = match (member.layer, &member.under) {
            (Layer::Profile, _) => format!("set by {}", profile(member)?),
            (_, Some(under)) if under.table().is_none() => {
                format!("`{}` in {}", self.sources.slice(under.at)?, self.sources.get(under.at.file)?.path)
            }
            _ => String::new(),
        };
        let source = (1..path.len()).rev().find_map(|length| {
            let table = self.in_description(path.get(..length)?)?.node.table()?;
            super::thing::text(table, "source")
        });
        if let Some(source) = source.filter(|_| member.layer != Layer::Profile) {
            let separator = if said.is_empty() { "" } else { "; " };
            said.push_str(&format!("{separator}source: {source}"));
        }
        (!said.is_empty()).then_some(said)
    }
}

/// A text whose columns stay below each other.
fn fenced(text: &str) -> String {
    format!("```text\n{text}\n```")
}
