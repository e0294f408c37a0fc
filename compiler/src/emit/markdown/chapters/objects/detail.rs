//! What there is to say of an object beyond its line in the table.

use serde::Serialize;

use super::{is_mapping, overview, per_axis};
use crate::emit::markdown::context::{Context, is_single};
use crate::emit::markdown::inline::{code, link, list, sentence, small, text};
use crate::emit::markdown::table::Table;
use crate::model::{Entry, Object, Source, Trigger};

/// An object with more to say.
#[derive(Serialize)]
pub(super) struct ObjectView {
    anchor: String,
    index: String,
    name: String,
    about: String,
    facts: Vec<String>,
    entries: Vec<String>,
    values: Vec<ValuesView>,
    source: String,
}

/// What the values of an entry mean.
#[derive(Serialize)]
struct ValuesView {
    caption: String,
    table: Table,
}

/// What there is to say of an object, if there is anything.
pub(super) fn detail(context: &Context<'_>, object: &Object) -> Option<ObjectView> {
    if is_mapping(context, object) {
        return None;
    }
    let view = ObjectView {
        anchor: context.object_id(object),
        index: code(object.index),
        name: text(&object.name),
        about: context.paragraphs(object.about.as_deref()),
        facts: facts(context, object),
        entries: entries(context, object),
        values: object.entries.iter().filter_map(|entry| values(context, object, entry)).collect(),
        source: small(&context.source(object.source.as_ref())),
    };
    let silent =
        view.about.is_empty() && view.facts.is_empty() && view.entries.is_empty() && view.values.is_empty();
    (!silent).then_some(view)
}

fn facts(context: &Context<'_>, object: &Object) -> Vec<String> {
    let mut facts = Vec::new();
    facts.extend((!object.functional).then(|| NO_FUNCTION.into()));
    facts.extend(object.note.iter().map(|note| sentence(&context.prose(note))));
    facts.extend(
        object.parameter.iter().map(|parameter| format!("The vendor's parameter {}.", text(parameter))),
    );
    if let ([only], true) = (object.entries.as_slice(), is_single(object)) {
        facts.extend(statements(context, only).into_iter().filter(|fact| !told(context, object, fact)));
    }
    facts.dedup();
    facts.extend(uses(context, object));
    facts.extend(per_axis::differences(context, object));
    facts
}

/// Whether a statement of the only entry was made of the object already.
fn told(context: &Context<'_>, object: &Object, fact: &str) -> bool {
    let about = object.about.as_deref().map(|about| sentence(&context.prose(about)));
    let note = object.note.as_deref().map(|note| sentence(&context.prose(note)));
    let parameter =
        object.parameter.as_deref().map(|parameter| format!("The vendor's parameter {}.", text(parameter)));
    let functional = (!object.functional).then(|| NO_FUNCTION.to_owned());
    [about, note, parameter, functional].into_iter().flatten().any(|one| one == fact)
}

const NO_FUNCTION: &str = "It exists for compatibility only and has no function.";

/// A line for each entry that has something to say.
fn entries(context: &Context<'_>, object: &Object) -> Vec<String> {
    if is_single(object) {
        return Vec::new();
    }
    let spoken = object.entries.iter().filter_map(|entry| {
        let mut statements = statements(context, entry);
        statements.retain(|fact| !told(context, object, fact));
        statements.extend(source(context, entry.source.as_ref(), object.source.as_ref()));
        let subindex = code(format!(":{:02X}", entry.address.subindex));
        (!statements.is_empty())
            .then(|| format!("{subindex} **{}**: {}", text(&entry.name), statements.join(" ")))
    });
    spoken.collect()
}

fn source(context: &Context<'_>, own: Option<&Source>, objects: Option<&Source>) -> Option<String> {
    own.filter(|own| Some(*own) != objects).map(|own| small(&context.source(Some(own))))
}

/// What is to be said of an entry, a sentence each.
fn statements(context: &Context<'_>, entry: &Entry) -> Vec<String> {
    let functional = (!entry.functional).then(|| NO_FUNCTION.into());
    let about = entry.about.iter().map(|about| sentence(&context.prose(about)));
    let note = entry.note.iter().map(|note| sentence(&context.prose(note)));
    let parameter =
        entry.parameter.iter().map(|parameter| format!("The vendor's parameter {}.", text(parameter)));
    let written = entry.written.iter().map(|change| format!("To be written during {}.", code(change)));
    let trigger = entry.trigger.iter().map(|trigger| trigger_text(context, entry, trigger));
    functional.into_iter().chain(about).chain(note).chain(parameter).chain(written).chain(trigger).collect()
}

fn trigger_text(context: &Context<'_>, entry: &Entry, trigger: &Trigger) -> String {
    let mut text =
        format!("Writing {}: {}", context.value(entry, &trigger.value), context.prose(&trigger.action));
    if let Some(mode) = trigger.mode {
        text.push_str(&format!("; needs mode {}", context.mode(mode)));
    }
    if !trigger.uses.is_empty() {
        text.push_str(&format!(
            "; takes {}",
            list(trigger.uses.iter().map(|address| context.whole(*address)))
        ));
    }
    if !trigger.updates.is_empty() {
        text.push_str(&format!(
            "; changes {}",
            list(trigger.updates.iter().map(|address| context.whole(*address)))
        ));
    }
    sentence(&text)
}

/// Where the object is used: words, PDOs, modes.
fn uses(context: &Context<'_>, object: &Object) -> Vec<String> {
    let device = context.device;
    let words = device.words.iter().filter(|word| word.address.index == object.index);
    let words = list(words.map(|word| link(text(&word.name), context.word_id(&word.id))));
    let maps = |pdo: &&crate::model::Pdo| {
        pdo.entries.iter().any(|mapped| mapped.address.is_some_and(|address| address.index == object.index))
    };
    let pdos = list(context.leading_pdos().filter(maps).map(|pdo| context.index(pdo.index)));
    let uses = |mode: &&crate::model::Mode| mode.objects.iter().any(|address| address.index == object.index);
    let modes = list(device.modes.iter().filter(uses).map(|mode| context.mode(mode.code)));
    let lines = [("Bits", words), ("In process data", pdos), ("Used by mode", modes)];
    lines
        .into_iter()
        .filter(|(_, what)| !what.is_empty())
        .map(|(title, what)| format!("{title}: {what}"))
        .collect()
}

fn values(context: &Context<'_>, object: &Object, entry: &Entry) -> Option<ValuesView> {
    let table = Table::of(["Value", "Meaning", "In full"], &entry.values, |meaning| {
        let about = context.optional(meaning.about.as_deref());
        [context.number_of(entry, meaning.value.into()), text(&meaning.name), about]
    });
    let caption =
        if is_single(object) { String::new() } else { format!("{}:", context.named(entry.address)) };
    let hidden = overview::is_count(object, entry) || table.is_empty();
    (!hidden).then_some(ValuesView { caption, table })
}
