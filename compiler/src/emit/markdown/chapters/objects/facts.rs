//! What objects and entries both can say, a sentence each.

use std::collections::{BTreeMap, BTreeSet};

use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{code, list, sentence, text};
use crate::model::{Address, Effective, Entry, Object, Property, Safety, SdoAccess, Stored, Trigger};
use crate::source::Origin;

/// What objects and entries both can say.
pub(super) struct Facts<'a> {
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
    /// What an object says. The rest of it stands in the table and in the lines of its entries.
    pub(super) fn of_object(object: &'a Object) -> Self {
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
    pub(super) fn of_entry(entry: &'a Entry) -> Self {
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

    pub(super) fn sentences(&self, context: &Context<'_>) -> Vec<String> {
        let marked = |key: &str, text: String| text + &context.mark(self.origin, key);
        let prose =
            |key: &str, text: Option<&str>| text.map(|text| marked(key, sentence(&context.prose(text))));
        let functional = (!self.functional)
            .then(|| marked("functional", "It is there for compatibility only and does nothing.".into()));
        let about = prose("about", self.about);
        let note = prose("note", self.note);
        let said = [functional, about, note].into_iter().flatten();
        let kept = self.kept().into_iter();
        said.chain(kept.map(|(key, text)| marked(key, text))).collect()
    }

    /// What is not in its own words, with the keys that say it.
    pub(super) fn kept(&self) -> Vec<(&'static str, String)> {
        let backup = self.backup.then(|| ("backup", "A backup of the device holds it.".to_owned()));
        let setting =
            self.setting.then(|| ("setting", "It is one of the settings of an application.".to_owned()));
        let safety = self.safety.map(|safety| ("safety", safe(safety).to_owned()));
        let transfer = self.sdo_access.map(|access| ("sdo-access", transferred(access).to_owned()));
        let effective = self.effective.map(|when| ("effective", sentence(when.sentence())));
        let stored = self.stored.map(|how| ("stored", sentence(how.sentence())));
        let said = [backup, setting, safety, transfer, effective, stored].into_iter().flatten();
        said.chain(self.properties.iter().map(|one| ("properties", property(one)))).collect()
    }
}

/// What is said of an entry on another axis that is not said of that of the first, but for what has words of its own; with the
/// keys that say it.
pub(super) fn on_axis(context: &Context<'_>, first: &Entry, entry: &Entry) -> Vec<(&'static str, String)> {
    let told = Facts::of_entry(first).kept();
    let mut own = Facts::of_entry(entry).kept();
    own.retain(|one| !told.contains(one));
    let trigger = entry.trigger.as_ref().filter(|_| first.trigger != entry.trigger);
    let trigger = trigger.map(|trigger| ("trigger", trigger_text(context, entry, trigger)));
    own.into_iter().chain(trigger).map(|(key, text)| (key, clause(&text))).collect()
}

/// A sentence as a part of another.
fn clause(sentence: &str) -> String {
    let mut chars = sentence.trim_end_matches('.').chars();
    chars.next().map(|first| first.to_lowercase().chain(chars).collect()).unwrap_or_default()
}

/// What writing a value sets off.
pub(super) fn triggered(context: &Context<'_>, entry: &Entry, trigger: &Trigger) -> String {
    trigger_text(context, entry, trigger) + &context.mark(&entry.origin, "trigger")
}

fn trigger_text(context: &Context<'_>, entry: &Entry, trigger: &Trigger) -> String {
    let mut text =
        format!("Writing {}: {}", context.value(entry, &trigger.value), context.prose(&trigger.action));
    if let Some(mode) = trigger.mode {
        text.push_str(&format!("; only in mode {}", context.mode(mode)));
    }
    if !trigger.uses.is_empty() {
        text.push_str(&format!("; it takes {}", reached(context, &trigger.uses)));
    }
    if !trigger.updates.is_empty() {
        text.push_str(&format!("; it changes {}", reached(context, &trigger.updates)));
    }
    sentence(&text)
}

/// The objects of a list of references; what each axis has once.
fn reached(context: &Context<'_>, addresses: &[Address]) -> String {
    let leading = |address: &Address| {
        let object = context.device.object(address.index);
        Address { index: object.map_or(address.index, |object| object.leading), ..*address }
    };
    let mut copies: BTreeMap<Address, BTreeSet<Address>> = BTreeMap::new();
    for address in addresses {
        copies.entry(leading(address)).or_default().insert(*address);
    }
    let axes = context.device.axes.len();
    let is_of_each =
        |first: &Address| axes > 1 && copies.get(first).is_some_and(|copies| copies.len() == axes);
    list(addresses.iter().filter_map(|address| match leading(address) {
        first if !is_of_each(&first) => Some(context.named(*address)),
        first => (first == *address).then(|| context.named(first) + " of each axis"),
    }))
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
