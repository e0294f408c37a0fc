//! What the axes do not share: the indices, and what differs from the first axis.

use super::facts::on_axis;
use super::is_mapping;
use super::overview::{access, mappable};
use crate::emit::markdown::context::{Context, is_single};
use crate::emit::markdown::inline::{code, link, list, sentence, text};
use crate::emit::markdown::table::{Table, Title};
use crate::model::{Entry, Object, Provenance, facts, provenance};
use crate::source::Origin;

/// The index of each object on each axis.
pub(super) fn indices(context: &Context<'_>, objects: &[&Object]) -> Table {
    let mut table = Table::new([Title::from("Object")].into_iter().chain(context.axis_titles("Axis")));
    let own = |object: &&&Object| object.axis.is_some() && !is_mapping(context, object);
    for object in objects.iter().filter(|_| context.has_axes()).filter(own) {
        let name = link(text(&object.name), context.object_id(object));
        let places = context.on_axes(object).into_iter();
        let places = places.map(|place| place.map_or_else(|| "–".into(), |object| code(object.index)));
        table.row([name].into_iter().chain(places));
    }
    table
}

/// What differs from the first axis, a sentence for all axes that differ alike.
pub(super) fn differences(context: &Context<'_>, leading: &Object) -> Vec<String> {
    if leading.axis.is_none() {
        return Vec::new();
    }
    let mut groups: Vec<(Vec<u8>, String)> = Vec::new();
    for (axis, object) in (0..=u8::MAX).zip(context.on_axes(leading)) {
        let text =
            object.map_or_else(|| "not there".into(), |object| compare(context, leading, object).join(", "));
        let own = object.filter(|object| object.source != leading.source);
        let text = match own.map_or(String::new(), |object| context.source(object.source.as_ref())) {
            source if source.is_empty() || text.is_empty() => text + &source,
            source => format!("{text} {source}"),
        };
        match groups.iter_mut().find(|(_, same)| *same == text) {
            Some((axes, _)) => axes.push(axis),
            None => groups.push((vec![axis], text)),
        }
    }
    // one reason for all of the object stands beside its name
    let has_own = leading.origin.node("assumed.per-axis").is_some();
    let mark = if has_own { context.mark(&leading.origin, "per-axis") } else { String::new() };
    let told = groups.into_iter().filter(|(_, text)| !text.is_empty());
    let told = told.map(|(axes, text)| {
        let words = sentence(&format!("on {}: {text}", context.axes(&axes))) + &mark;
        context.for_axes(&axes, words)
    });
    told.collect()
}

/// What is different about an object on its axis, in words.
fn compare(context: &Context<'_>, leading: &Object, object: &Object) -> Vec<String> {
    let single = is_single(object);
    let mut changes = Changes::new(context, &leading.origin, &object.origin);
    changes.note(leading.name != object.name, &["name"], || format!("called {}", text(&object.name)));
    changes.note(leading.functional && !object.functional, &["functional"], || NO_FUNCTION.into());
    changes.prose("about", &leading.about, &object.about);
    changes.prose("note", &leading.note, &object.note);
    let mut changes = changes.all();
    for entry in &object.entries {
        let mut own = match leading.entry(entry.address.subindex) {
            Some(first) => compare_entries(context, first, entry),
            None => vec![text(&entry.name)],
        };
        own.retain(|change| !changes.contains(change));
        let prefix =
            if single { String::new() } else { code(format!(":{:02X}", entry.address.subindex)) + " " };
        changes.extend(own.into_iter().map(|change| format!("{prefix}{change}")));
    }
    changes
}

const NO_FUNCTION: &str = "no function";

fn compare_entries(context: &Context<'_>, first: &Entry, entry: &Entry) -> Vec<String> {
    let mut changes = Changes::new(context, &first.origin, &entry.origin);
    let renamed = entry.address.subindex > 0 && first.name != entry.name;
    changes.note(renamed, &["name"], || format!("called {}", text(&entry.name)));
    changes.note(first.functional && !entry.functional, &["functional"], || NO_FUNCTION.into());
    changes.note(first.data_type != entry.data_type, &["type"], || entry.data_type.to_string());
    changes.note(first.access != entry.access, &["access"], || format!("access {}", access(entry.access)));
    changes.note(first.pdo != entry.pdo, &["pdo"], || format!("PDO {}", mappable(entry.pdo)));
    let default = || format!("default {}", context.default(entry));
    changes.note(first.default != entry.default, &["default"], default);
    let ranges = [first, entry].map(|entry| context.range(entry));
    changes.note(ranges[0] != ranges[1], &["min", "max"], || format!("range {}", ranges[1]));
    changes.note(first.unit != entry.unit, &["unit"], || format!("unit {}", context.unit(entry)));
    let parameter = entry.parameter.as_deref().filter(|_| first.parameter != entry.parameter);
    let parameter = parameter.map(|parameter| format!("parameter {}", text(parameter)));
    changes.maybe("parameter", parameter);
    let window = entry.written.filter(|_| first.written != entry.written);
    changes.maybe("written", window.map(|window| format!("written in {}", code(window.name()))));
    changes.note(first.values != entry.values, &["values"], || {
        let values = entry
            .values
            .iter()
            .map(|it| format!("{} {}", context.number_of(entry, it.value.into()), text(&it.name)));
        format!("values {}", list(values))
    });
    on_axis(context, first, entry).into_iter().for_each(|(key, text)| changes.maybe(key, Some(text)));
    changes.prose("about", &first.about, &entry.about);
    changes.prose("note", &first.note, &entry.note);
    changes.all()
}

/// What is different, in words, each with the marks of what no source states.
struct Changes<'c> {
    context: &'c Context<'c>,
    first: &'c Origin,
    own: &'c Origin,
    told: Vec<String>,
    marked: Vec<String>,
}

impl<'c> Changes<'c> {
    fn new(context: &'c Context<'c>, first: &'c Origin, own: &'c Origin) -> Self {
        Self { context, first, own, told: Vec::new(), marked: Vec::new() }
    }

    fn note(&mut self, different: bool, keys: &[&str], words: impl FnOnce() -> String) {
        if different {
            let keys: Vec<&str> =
                keys.iter().filter(|key| self.departs(key, &provenance(self.own, key))).copied().collect();
            self.told.push(words() + &self.context.marks(self.own, &keys));
            self.marked.extend(keys.into_iter().map(str::to_owned));
        }
    }

    fn maybe(&mut self, key: &str, words: Option<String>) {
        words.into_iter().for_each(|words| self.note(true, &[key], || words));
    }

    fn prose(&mut self, key: &str, first: &Option<String>, own: &Option<String>) {
        let own = own.as_ref().filter(|_| first != own);
        self.maybe(key, own.map(|own| self.context.prose(own)));
    }

    /// Whether somebody else than on the first axis says what no source states.
    fn departs(&self, key: &str, who: &Provenance) -> bool {
        let is_stated = matches!(who, Provenance::Stated | Provenance::Profile | Provenance::Derived);
        self.context.editorial && !is_stated && provenance(self.first, key) != *who
    }

    /// All of it, and last what is assumed, corrected or contradicted on this axis only and shows no difference.
    fn all(self) -> Vec<String> {
        let others = facts(self.own).into_iter();
        let others = others
            .filter(|(path, who)| !self.marked.contains(path) && self.departs(path, who))
            .map(|(path, _)| format!("{}{}", text(&path), self.context.mark(self.own, &path)));
        let others: Vec<String> = others.collect();
        self.told.into_iter().chain(others).collect()
    }
}
