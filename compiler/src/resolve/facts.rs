//! Sources, assumptions, remarks and errata.

use super::context::Context;
use crate::model::{Assumption, Document, Erratum, Remark, RemarkKind, Source};
use crate::raw::{
    Entity, ObjectEntity, RawAssumed, RawDevice, RawDocument, RawErratum, RawFacts, RawRemark, RawRemarkKind,
};
use crate::source::{Location, Origin};

/// The documents, in the order in which they were written.
pub(super) fn documents(raw: &[Entity<RawDocument>]) -> Vec<Document> {
    raw.iter()
        .map(|Entity { key, raw, .. }| Document {
            id: key.clone(),
            title: raw.title.clone(),
            number: raw.number.clone(),
            edition: raw.edition.clone(),
            publisher: raw.publisher.clone(),
            about: raw.about.clone(),
        })
        .collect()
}

/// The place that a `source` names: in the document before the colon, or in the main one.
pub(super) fn source(context: &Context<'_>, facts: &RawFacts) -> Option<Source> {
    let text = facts.source.as_deref()?;
    let known = |id: &str| context.documents.iter().any(|document| document.id == id);
    Some(match text.split_once(": ") {
        Some((document, place)) if known(document) => {
            Source { document: Some(document.to_owned()), place: place.to_owned() }
        }
        _ => Source {
            document: context.documents.first().map(|document| document.id.clone()),
            place: text.to_owned(),
        },
    })
}

/// What the tables of a description say that no source states.
pub(super) fn assumptions(context: &Context<'_>, raw: &RawDevice) -> Vec<Assumption> {
    let mut list = Vec::new();
    let mut single = |section: &str, facts: &RawFacts, origin: &Origin| {
        list.extend(assumed(context, section, facts, origin));
    };
    single("device", &raw.head.facts, &raw.head.origin);
    single("identity", &raw.identity.facts, &raw.identity.origin);
    one(&raw.eeprom, "eeprom", &mut single);
    one(&raw.axes, "axes", &mut single);
    one(&raw.mailbox, "mailbox", &mut single);
    one(&raw.dead_time, "dead-time", &mut single);
    one(&raw.device_control, "device-control", &mut single);
    one(&raw.coordinates, "coordinates", &mut single);
    each_of(&raw.sync_managers, "sync-managers", &mut single);
    for ObjectEntity { object, entries, .. } in &raw.objects {
        // A coordinate of the vendor is one of several ways to write an index.
        let index = context.names.key(&object.key).map(|index| index.to_string());
        let key = index.unwrap_or_else(|| object.key.clone());
        single(&key, &object.facts, &object.origin);
        for entry in entries {
            single(&format!("{key}:{}", entry.key), &entry.facts, &entry.origin);
        }
    }
    for pdo in raw.rx_pdos.iter().chain(&raw.tx_pdos) {
        single(&pdo.key, &pdo.facts, &pdo.origin);
    }
    each_of(&raw.words, "words", &mut single);
    each_of(&raw.states, "states", &mut single);
    each_of(&raw.commands, "commands", &mut single);
    each_of(&raw.transitions, "transitions", &mut single);
    each_of(&raw.communication_states, "communication-states", &mut single);
    each_of(&raw.communication_transitions, "communication-transitions", &mut single);
    each_of(&raw.modes, "modes", &mut single);
    each_of(&raw.mode_changes, "mode-changes", &mut single);
    each_of(&raw.stop_options, "stop-options", &mut single);
    each_of(&raw.errors, "errors", &mut single);
    each_of(&raw.vendor_codes, "vendor-codes", &mut single);
    each_of(&raw.units, "units", &mut single);
    each_of(&raw.sync_modes, "sync-modes", &mut single);
    each_of(&raw.cycle_times, "cycle-times", &mut single);
    each_of(&raw.leds, "leds", &mut single);
    each_of(&raw.connectors, "connectors", &mut single);
    each_of(&raw.parameters, "parameters", &mut single);
    each_of(&raw.homing_methods, "homing-methods", &mut single);
    each_of(&raw.registers, "registers", &mut single);
    each_of(&raw.al_status_codes, "al-status-codes", &mut single);
    each_of(&raw.telegrams, "telegrams", &mut single);
    each_of(&raw.configurations, "configurations", &mut single);
    each_of(&raw.limits, "limits", &mut single);
    each_of(&raw.master_settings, "master-settings", &mut single);
    each_of(&raw.procedures, "procedures", &mut single);
    list
}

fn one<T>(entity: &Option<Entity<T>>, name: &str, single: &mut impl FnMut(&str, &RawFacts, &Origin)) {
    if let Some(entity) = entity {
        single(name, &entity.facts, &entity.origin);
    }
}

fn each_of<T>(entities: &[Entity<T>], section: &str, single: &mut impl FnMut(&str, &RawFacts, &Origin)) {
    for entity in entities {
        single(&format!("{section}.{}", entity.key), &entity.facts, &entity.origin);
    }
}

fn assumed(context: &Context<'_>, at: &str, facts: &RawFacts, origin: &Origin) -> Vec<Assumption> {
    let one = |at: String, value: Option<String>, reason: &String| Assumption {
        at,
        value,
        reason: reason.clone(),
        origin: origin.clone(),
    };
    match &facts.assumed {
        None => Vec::new(),
        Some(RawAssumed::All(reason)) => vec![one(at.to_owned(), None, reason)],
        Some(RawAssumed::Keys(keys)) => keys
            .iter()
            .map(|(key, reason)| {
                let value = origin.has(key).then(|| written(context, origin.value(key)));
                one(format!("{at}.{key}"), value, reason)
            })
            .collect(),
    }
}

/// The text that stands at a place, without the quotes.
fn written(context: &Context<'_>, at: Location) -> String {
    let text = context
        .sources
        .get(at.file)
        .and_then(|file| file.text.get(usize::try_from(at.start).ok()?..usize::try_from(at.end).ok()?));
    text.unwrap_or_default().trim_matches('"').to_owned()
}

/// The weaknesses that no rule can see.
pub(super) fn remarks(context: &Context<'_>, raw: Vec<Entity<RawRemark>>) -> Vec<Remark> {
    raw.into_iter()
        .map(|Entity { raw, facts, .. }| Remark {
            source: source(context, &facts),
            at: raw.at,
            kind: match raw.kind {
                RawRemarkKind::Contradiction => RemarkKind::Contradiction,
                RawRemarkKind::Silence => RemarkKind::Silence,
                RawRemarkKind::Doubt => RemarkKind::Doubt,
            },
            text: raw.text,
        })
        .collect()
}

/// The answers to findings.
pub(super) fn errata(context: &Context<'_>, raw: Vec<Entity<RawErratum>>) -> Vec<Erratum> {
    raw.into_iter()
        .map(|Entity { raw, facts, origin, .. }| Erratum {
            source: source(context, &facts),
            rule: raw.rule,
            at: raw.at,
            says: raw.says,
            holds: raw.holds,
            why: raw.why,
            origin,
        })
        .collect()
}
