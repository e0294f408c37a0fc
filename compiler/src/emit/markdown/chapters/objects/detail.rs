//! What there is to say of an object beyond its line in the table.

use super::facts::{Facts, triggered};
use super::{is_mapping, overview, per_axis};
use crate::emit::markdown::context::{Context, is_single};
use crate::emit::markdown::inline::{anchor, code, link, list, text};
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{Entry, Mode, Object, Pdo, Source};

/// What there is to say of an object.
pub(super) enum Detail {
    /// No more than a paragraph.
    Brief(String),
    /// Entries or values of their own.
    Full(Page),
}

/// What there is to say of an object, if there is anything; its source unless it is that of the whole area.
pub(super) fn detail(context: &Context<'_>, object: &Object, common: Option<&Source>) -> Option<Detail> {
    if is_mapping(context, object) {
        return None;
    }
    let about = statements(context, object).join(" ");
    let entries = entries(context, object);
    let mut values = Page::default();
    object.entries.iter().for_each(|entry| self::values(context, object, entry, &mut values));
    let source = context.source_line(object.source.as_ref().filter(|source| Some(*source) != common));
    let (index, name) = (code(object.index), text(&object.name));
    let id = context.object_id(object);
    match (about.is_empty(), entries.is_empty() && values.is_empty()) {
        (true, true) if source.is_empty() => None,
        (_, true) => Some(Detail::Brief(
            format!("{}{index} **{name}**: {about} {source}", anchor(id)).trim_end().into(),
        )),
        (_, false) => {
            let mut page = Page::default();
            page.place(4, id, format!("{index} {name}"));
            page.text(about);
            page.list(entries);
            page.append(values);
            page.text(source);
            Some(Detail::Full(page))
        }
    }
}

/// What is to be said of an object, a sentence each.
fn statements(context: &Context<'_>, object: &Object) -> Vec<String> {
    let mut statements = Facts::of_object(object).sentences(context);
    if let ([only], true) = (object.entries.as_slice(), is_single(object)) {
        statements.extend(Facts::of_entry(only).sentences(context));
        statements.extend(only.trigger.iter().map(|trigger| triggered(context, only, trigger)));
    }
    statements.extend(uses(context, object));
    statements.extend(per_axis::differences(context, object));
    let mut told: Vec<String> = Vec::new();
    statements.into_iter().for_each(|one| {
        if !told.contains(&one) {
            told.push(one);
        }
    });
    told
}

/// A line for each entry that has something to say which the object has not said.
fn entries(context: &Context<'_>, object: &Object) -> Vec<String> {
    if is_single(object) {
        return Vec::new();
    }
    let told = Facts::of_object(object).sentences(context);
    let spoken = object.entries.iter().filter_map(|entry| {
        let mut statements = Facts::of_entry(entry).sentences(context);
        statements.retain(|one| !told.contains(one));
        statements.extend(entry.trigger.iter().map(|trigger| triggered(context, entry, trigger)));
        let own = entry.source.as_ref().filter(|own| Some(*own) != object.source.as_ref());
        statements.extend(own.map(|own| context.source(Some(own))));
        let subindex = code(format!(":{:02X}", entry.address.subindex));
        (!statements.is_empty())
            .then(|| format!("{subindex} **{}**: {}", text(&entry.name), statements.join(" ")))
    });
    spoken.collect()
}

/// What is said of the mapping object of a PDO besides what it maps.
pub(in crate::emit::markdown::chapters) fn of_mapping(
    context: &Context<'_>,
    object: &Object,
    page: &mut Page,
) {
    page.text(Facts::of_object(object).sentences(context).join(" "));
    page.list(entries(context, object));
    object.entries.iter().for_each(|entry| values(context, object, entry, page));
}

/// Where the object is used: words, PDOs, modes.
fn uses(context: &Context<'_>, object: &Object) -> Vec<String> {
    let device = context.device;
    let words = device.words.iter().filter(|word| word.address.index == object.index);
    let words = list(words.map(|word| link(text(&word.name), context.word_id(&word.id))));
    let maps = |pdo: &&Pdo| {
        pdo.entries.iter().any(|mapped| mapped.address.is_some_and(|address| address.index == object.index))
    };
    let pdos = list(context.leading_pdos().filter(maps).map(|pdo| context.index(pdo.index)));
    let uses = |mode: &&Mode| mode.objects.iter().any(|address| address.index == object.index);
    let modes = list(device.modes.iter().filter(uses).map(|mode| context.mode_code(mode.code)));
    let lines = [("Bits: see", words), ("Mapped in", pdos), ("Used by mode", modes)];
    let lines = lines.into_iter().filter(|(_, what)| !what.is_empty());
    lines.map(|(title, what)| format!("{title} {what}.")).collect()
}

/// What the values of an entry mean.
fn values(context: &Context<'_>, object: &Object, entry: &Entry, page: &mut Page) {
    if overview::is_count(context, object, entry) || entry.values.is_empty() {
        return;
    }
    let mark = context.mark(&entry.origin, "values") + &of_enumeration(context, entry);
    if !is_single(object) {
        let subindex = code(format!(":{:02X}", entry.address.subindex));
        page.text(format!("{subindex} **{}**:{mark}", text(&entry.name)));
    } else if !mark.is_empty() {
        page.text(format!("Values:{mark}"));
    }
    page.table(Table::of(["Value", "Meaning", "In full"], &entry.values, |meaning| {
        let about = context.optional(meaning.about.as_deref());
        [context.meant(entry, meaning), text(&meaning.name), about]
    }));
}

/// The mark of an enumeration that the values of an entry are from.
fn of_enumeration(context: &Context<'_>, entry: &Entry) -> String {
    let named = context.device.enumeration_of(entry);
    named.map_or(String::new(), |named| context.mark(&named.origin, "values"))
}
