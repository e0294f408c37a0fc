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
    let told = groups.into_iter().filter(|(_, text)| !text.is_empty());
    let told = told.map(|(axes, text)| {
        let words = sentence(&format!("on {}: {text}", context.axes(&axes)));
        context.for_axes(&axes, words)
    });
    told.collect()
}

/// What is different about an object on its axis, in words.
fn compare(context: &Context<'_>, leading: &Object, object: &Object) -> Vec<String> {
    let single = is_single(object);
    let mut changes = Changes::default();
    changes.note(leading.name != object.name, || format!("called {}", text(&object.name)));
    changes.note(leading.functional && !object.functional, || NO_FUNCTION.into());
    changes.prose(context, &leading.about, &object.about);
    changes.prose(context, &leading.note, &object.note);
    changes.answers(context, &leading.origin, &object.origin);
    for entry in &object.entries {
        let mut own = Changes::default();
        match leading.entry(entry.address.subindex) {
            Some(first) => compare_entries(context, first, entry, &mut own),
            None => own.0.push(text(&entry.name)),
        }
        own.0.retain(|change| !changes.0.contains(change));
        let prefix =
            if single { String::new() } else { code(format!(":{:02X}", entry.address.subindex)) + " " };
        changes.0.extend(own.0.into_iter().map(|change| format!("{prefix}{change}")));
    }
    changes.0
}

const NO_FUNCTION: &str = "no function";

fn compare_entries(context: &Context<'_>, first: &Entry, entry: &Entry, changes: &mut Changes) {
    let renamed = entry.address.subindex > 0 && first.name != entry.name;
    changes.note(renamed, || format!("called {}", text(&entry.name)));
    changes.note(first.functional && !entry.functional, || NO_FUNCTION.into());
    changes.note(first.data_type != entry.data_type, || entry.data_type.to_string());
    changes.note(first.access != entry.access, || format!("access {}", access(entry.access)));
    changes.note(first.pdo != entry.pdo, || format!("PDO {}", mappable(entry.pdo)));
    changes.note(first.default != entry.default, || format!("default {}", context.default(entry)));
    let ranges = [first, entry].map(|entry| context.range(entry));
    changes.note(ranges[0] != ranges[1], || format!("range {}", ranges[1]));
    changes.note(first.unit != entry.unit, || format!("unit {}", context.unit(entry)));
    let parameter = entry.parameter.as_deref().filter(|_| first.parameter != entry.parameter);
    changes.0.extend(parameter.map(|parameter| format!("parameter {}", text(parameter))));
    let window = entry.written.filter(|_| first.written != entry.written);
    changes.0.extend(window.map(|window| format!("written in {}", code(window.name()))));
    changes.note(first.values != entry.values, || {
        let values = entry
            .values
            .iter()
            .map(|it| format!("{} {}", context.number_of(entry, it.value.into()), text(&it.name)));
        format!("values {}", list(values))
    });
    changes.0.extend(on_axis(context, first, entry));
    changes.prose(context, &first.about, &entry.about);
    changes.prose(context, &first.note, &entry.note);
    changes.answers(context, &first.origin, &entry.origin);
}

/// What is different, in words.
#[derive(Default)]
struct Changes(Vec<String>);

impl Changes {
    fn note(&mut self, different: bool, words: impl Fn() -> String) {
        self.0.extend(different.then(words));
    }

    /// What errata have changed, or doubt, on this axis only.
    fn answers(&mut self, context: &Context<'_>, first: &Origin, own: &Origin) {
        let told = facts(own).into_iter().filter(|(path, who)| {
            let is_answer = matches!(who, Provenance::Corrected(_) | Provenance::Contradicted(_));
            context.editorial && is_answer && provenance(first, path) != *who
        });
        self.0.extend(told.map(|(path, _)| format!("{}{}", text(&path), context.mark(own, &path))));
    }

    fn prose(&mut self, context: &Context<'_>, first: &Option<String>, own: &Option<String>) {
        if first != own {
            self.0.extend(own.iter().map(|own| context.prose(own)));
        }
    }
}
