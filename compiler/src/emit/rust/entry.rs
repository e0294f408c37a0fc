//! What there is to say about an entry.

use super::axes::Placed;
use super::default;
use super::departures::Departures;
use super::doc::{Doc, escape, place, sentence};
use super::scope::Scope;
use crate::model::{Access, Entry, Mappable, Object, Scale, Source, Unit};

/// Index, name, type, access, range, unit, meaning and source. What departs from it is given for an entry of several.
pub(super) fn doc(
    scope: &Scope<'_>,
    placed: &Placed<'_, Object>,
    entry: &Entry,
    departures: Option<&Departures>,
) -> Doc {
    let object = placed.first;
    let is_alone = object.entries.len() == 1;
    let about = entry.about.as_deref().or(object.about.as_deref().filter(|_| is_alone));
    let note = entry.note.as_deref().or(object.note.as_deref().filter(|_| is_alone));
    let source = entry.source.as_ref().or(object.source.as_ref().filter(|_| is_alone));
    let doc = Doc::new(format!("{} {}", title(entry), facts(scope, entry, source)))
        .maybe(about)
        .maybe(note)
        .maybe(trigger(entry).as_deref())
        .maybe(without_function(scope, placed, entry).as_deref());
    match departures {
        Some(departures) => departures.at_entry(doc, entry.address.subindex, scope.device),
        None => doc.said(None, &entry.origin, scope.device),
    }
}

/// What there is to say about an object of several entries.
pub(super) fn object_doc(scope: &Scope<'_>, object: &Object, departures: &Departures) -> Doc {
    let doc = Doc::new(format!("`{}` {}", object.index, sentence(&object.name)))
        .maybe(object.about.as_deref())
        .maybe(object.note.as_deref())
        .said(object.source.as_ref(), &object.origin, scope.device);
    departures.at_object(doc, scope.device)
}

/// Address and name.
pub(super) fn title(entry: &Entry) -> String {
    format!("`{}` {}", entry.address, sentence(&entry.name))
}

/// All that is a single word or number, and where it is from.
pub(super) fn facts(scope: &Scope<'_>, entry: &Entry, source: Option<&Source>) -> String {
    let mut facts = vec![entry.data_type.to_string(), access(entry.access).to_owned()];
    facts.extend(mappable(entry.pdo).map(str::to_owned));
    facts.extend(entry.written.map(|window| format!("written in {} only", window.name())));
    facts.extend(range(entry));
    facts.extend(entry.default.as_ref().map(|_| format!("default {}", shown(entry))));
    facts.extend(entry.unit.as_ref().and_then(|id| scope.device.unit(id)).map(unit));
    let source = source.map(|source| format!(" ({})", place(source, scope.device))).unwrap_or_default();
    escape(&format!("{}{source}.", facts.join(", ")))
}

/// The unit of the raw value: `in mm or deg ÷ 1000`, and where the scale differs, too, `in mm ÷ 1000 or deg ÷ 10`.
pub(super) fn unit(unit: &Unit) -> String {
    let shared = unit.axes.first().map(|axis| axis.scale);
    let shared = shared.filter(|scale| unit.axes.iter().all(|axis| axis.scale == *scale));
    let mut steps: Vec<String> = Vec::new();
    for axis in &unit.axes {
        let ratio = if shared.is_some() { String::new() } else { ratio(axis.scale) };
        let step = format!("{}{ratio}", axis.symbol);
        if !steps.contains(&step) {
            steps.push(step);
        }
    }
    format!("in {}{}", steps.join(" or "), shared.map(ratio).unwrap_or_default())
}

/// A raw step as a part or a multiple of the unit.
fn ratio(scale: Option<Scale>) -> String {
    match scale.filter(|scale| scale.raw != scale.units) {
        Some(scale) if scale.units == 1 => format!(" ÷ {}", scale.raw),
        Some(scale) => format!(" × {} ÷ {}", scale.units, scale.raw),
        None => String::new(),
    }
}

/// The default as it is in code, but for the marks between digits.
fn shown(entry: &Entry) -> String {
    let code = default::value(entry).to_string();
    match code.strip_prefix("- ") {
        Some(number) => format!("-{number}"),
        None if code.starts_with(|c: char| c.is_ascii_digit()) => code.replace('_', ""),
        None => code,
    }
}

fn access(access: Access) -> &'static str {
    match access {
        Access::Ro => "ro",
        Access::Wo => "wo",
        Access::Rw => "rw",
        Access::Const => "const",
    }
}

fn mappable(pdo: Mappable) -> Option<&'static str> {
    match pdo {
        Mappable::None => None,
        Mappable::Rx => Some("RxPDO"),
        Mappable::Tx => Some("TxPDO"),
        Mappable::RxTx => Some("RxPDO and TxPDO"),
    }
}

fn range(entry: &Entry) -> Option<String> {
    match (&entry.min, &entry.max) {
        (Some(min), Some(max)) => Some(format!("{min} to {max}")),
        (Some(min), None) => Some(format!("{min} or more")),
        (None, Some(max)) => Some(format!("{max} or less")),
        (None, None) => None,
    }
}

fn trigger(entry: &Entry) -> Option<String> {
    let trigger = entry.trigger.as_ref()?;
    let mode = trigger.mode.map(|mode| format!(", in mode {mode} only")).unwrap_or_default();
    Some(format!("Writing {}: {}{mode}.", trigger.value, trigger.action))
}

/// The axes on which the entry does nothing.
fn without_function(scope: &Scope<'_>, placed: &Placed<'_, Object>, entry: &Entry) -> Option<String> {
    let idle = placed.all.iter().filter(|object| {
        let same = object.entry(entry.address.subindex);
        !object.functional || same.is_some_and(|entry| !entry.functional)
    });
    let name = |object: &&&Object| {
        let axis = object.axis.and_then(|axis| scope.device.axes.get(usize::from(axis)));
        axis.map(|axis| axis.name.as_str()).unwrap_or_default()
    };
    let names: Vec<&str> = idle.map(|object| name(&object)).collect();
    if names.is_empty() {
        None
    } else if names.len() == placed.all.len() {
        Some("There for compatibility only, it does nothing.".to_owned())
    } else {
        Some(format!("It does nothing on {}.", names.join(", ")))
    }
}
