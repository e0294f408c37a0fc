//! What there is to say of an object beyond its line in the table.

use super::{is_mapping, overview, per_axis};
use crate::emit::markdown::context::{Context, is_single};
use crate::emit::markdown::inline::{anchor, code, link, list, sentence, text};
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{
    Effective, Entry, Mode, Object, Pdo, Property, Safety, SdoAccess, Source, Stored, Trigger,
};
use crate::source::Origin;

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
        statements.extend(only.trigger.iter().map(|trigger| trigger_text(context, only, trigger)));
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
        statements.extend(entry.trigger.iter().map(|trigger| trigger_text(context, entry, trigger)));
        let own = entry.source.as_ref().filter(|own| Some(*own) != object.source.as_ref());
        statements.extend(own.map(|own| context.source(Some(own))));
        let subindex = code(format!(":{:02X}", entry.address.subindex));
        (!statements.is_empty())
            .then(|| format!("{subindex} **{}**: {}", text(&entry.name), statements.join(" ")))
    });
    spoken.collect()
}

/// What objects and entries both can say.
struct Facts<'a> {
    origin: &'a Origin,
    about: Option<&'a str>,
    note: Option<&'a str>,
    functional: bool,
    properties: &'a [Property],
    backup: bool,
    setting: bool,
    safety: Option<Safety>,
    sdo_access: Option<SdoAccess>,
    effective: Option<Effective>,
    stored: Option<Stored>,
}

impl<'a> Facts<'a> {
    /// The rest of an object stands in the table and in the lines of its entries.
    fn of_object(object: &'a Object) -> Self {
        let Object {
            about,
            note,
            functional,
            properties,
            sdo_access,
            index: _,
            id: _,
            name: _,
            names: _,
            kind: _,
            axis: _,
            category: _,
            entries: _,
            derived: _,
            parameter: _,
            leading: _,
            source: _,
            origin,
        } = object;
        Self {
            origin,
            about: about.as_deref(),
            note: note.as_deref(),
            functional: *functional,
            properties,
            backup: false,
            setting: false,
            safety: None,
            sdo_access: *sdo_access,
            effective: None,
            stored: None,
        }
    }

    /// The rest of an entry stands in the table; its values, its trigger and its source follow.
    fn of_entry(entry: &'a Entry) -> Self {
        let Entry {
            about,
            note,
            functional,
            properties,
            backup,
            setting,
            safety,
            parameter: _,
            effective,
            stored,
            address: _,
            id: _,
            name: _,
            names: _,
            data_type: _,
            access: _,
            pdo: _,
            category: _,
            unit: _,
            default: _,
            min: _,
            max: _,
            values: _,
            written: _,
            trigger: _,
            source: _,
            origin,
        } = entry;
        Self {
            origin,
            about: about.as_deref(),
            note: note.as_deref(),
            functional: *functional,
            properties,
            backup: *backup,
            setting: *setting,
            safety: *safety,
            sdo_access: None,
            effective: *effective,
            stored: *stored,
        }
    }

    fn sentences(&self, context: &Context<'_>) -> Vec<String> {
        let functional =
            (!self.functional).then(|| "It is there for compatibility only and does nothing.".into());
        let marked = |key: &str, text: &str| sentence(&context.prose(text)) + &context.mark(self.origin, key);
        let about = self.about.map(|about| marked("about", about));
        let note = self.note.map(|note| marked("note", note));
        let backup = self.backup.then(|| "A backup of the device holds it.".into());
        let setting = self.setting.then(|| "It is one of the settings of an application.".into());
        let safety = self.safety.map(|safety| safe(safety).into());
        let transfer = self.sdo_access.map(|access| transferred(access).into());
        let effective = self.effective.map(|when| sentence(when.sentence()));
        let stored = self.stored.map(|how| sentence(how.sentence()));
        let said = [functional, about, note, backup, setting, safety, transfer, effective, stored]
            .into_iter()
            .flatten();
        said.chain(self.properties.iter().map(property)).collect()
    }
}

fn trigger_text(context: &Context<'_>, entry: &Entry, trigger: &Trigger) -> String {
    let named = |addresses: &[_]| list(addresses.iter().map(|address| context.named(*address)));
    let mut text =
        format!("Writing {}: {}", context.value(entry, &trigger.value), context.prose(&trigger.action));
    if let Some(mode) = trigger.mode {
        text.push_str(&format!("; only in mode {}", context.mode(mode)));
    }
    if !trigger.uses.is_empty() {
        text.push_str(&format!("; it takes {}", named(&trigger.uses)));
    }
    if !trigger.updates.is_empty() {
        text.push_str(&format!("; it changes {}", named(&trigger.updates)));
    }
    sentence(&text)
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
    if overview::is_count(object, entry) || entry.values.is_empty() {
        return;
    }
    if !is_single(object) {
        let subindex = code(format!(":{:02X}", entry.address.subindex));
        page.text(format!("{subindex} **{}**:", text(&entry.name)));
    }
    page.table(Table::of(["Value", "Meaning", "In full"], &entry.values, |meaning| {
        let about = context.optional(meaning.about.as_deref());
        [context.number_of(entry, meaning.value.into()), text(&meaning.name), about]
    }));
}

/// What the vendor's tools are told.
fn property(property: &Property) -> String {
    let Property { name, value, about } = property;
    let value = value.as_ref().map_or(String::new(), |value| format!(" {}", code(value)));
    let about = about.as_ref().map_or(String::new(), |about| format!(": {}", text(about)));
    sentence(&format!("{}{value}{about}", text(name)))
}

fn safe(safety: Safety) -> &'static str {
    match safety {
        Safety::Inputs => "It is a safe input.",
        Safety::Outputs => "It is a safe output.",
        Safety::InputsOutputs => "It is a safe input and output.",
        Safety::Parameters => "Safety depends on it.",
    }
}

fn transferred(access: SdoAccess) -> &'static str {
    match access {
        SdoAccess::Complete => "Its entries are transferred all at once.",
        SdoAccess::Single => "Its entries are transferred one by one.",
    }
}
