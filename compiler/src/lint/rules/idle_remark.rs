use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Place, Remark, RemarkKind, Section};
use crate::raw;
use crate::source::{CanonicalKey, Location, parts};
use crate::text::near::near;

rule! {
    /// A remark is read where the thing is that it is about. One about a thing that is not there, or about a key that no table
    /// of its kind has, is read by nobody. Only of what the sources are silent about, nothing has to be there.
    ///
    /// ## Fires
    /// ```toml
    /// [leds.run]
    /// name = "RUN"
    ///
    /// [[remarks]]
    /// at = "leds.rum"
    /// kind = "doubt"
    /// text = "The drawing shows it in another place."
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [leds.run]
    /// name = "RUN"
    ///
    /// [[remarks]]
    /// at = "leds.run"
    /// kind = "doubt"
    /// text = "The drawing shows it in another place."
    /// ```
    pub(super) static RULE = "idle-remark", Facts, Warning, "a remark is about nothing";
}

/// It is asked of all members at once.
pub(super) fn check(_: &Device, _: &mut Report) {}

/// The remarks that are about nothing that any member has.
pub(in crate::lint) fn judge(members: &[Device]) -> impl Iterator<Item = Diagnostic> {
    let mut idle: BTreeMap<Location, (&Device, &Remark)> = BTreeMap::new();
    let mut of_any = BTreeSet::new();
    for device in members {
        for remark in device.remarks.iter().filter(|remark| remark.kind != RemarkKind::Silence) {
            let at = remark.origin.value("at");
            if is_there(device, &remark.at) {
                of_any.insert(at);
            }
            idle.entry(at).or_insert((device, remark));
        }
    }
    idle.retain(|at, _| !of_any.contains(at));
    idle.into_iter().map(|(at, (device, remark))| finding(device, remark, at))
}

fn finding(device: &Device, remark: &Remark, at: Location) -> Diagnostic {
    let message = format!("there is no {} for the remark to be about", remark.at);
    let diagnostic = Diagnostic::new(&RULE, message, at, "is not there");
    let known: Vec<String> = match unknown_key(&remark.at) {
        Some(_) => keys(&remark.at).iter().map(|key| remark.at.clone().with(key).to_string()).collect(),
        None => known(device, &remark.at),
    };
    match near(&remark.at.to_string(), known.iter().map(String::as_str)) {
        Some(near) => diagnostic.suggest(format!("there is `{near}`"), at, format!("\"{near}\"")),
        None => diagnostic.help("name what it is about, as an erratum would"),
    }
}

/// Whether the description or a standard has what a place names; what is below a table can be what is missing.
fn is_there(device: &Device, place: &Place) -> bool {
    if unknown_key(place).is_some() {
        return false;
    }
    let Some(key) = &place.key else { return true };
    match (place.section, key) {
        (Section::Objects | Section::RxPdos | Section::TxPdos, CanonicalKey::Range(index, _)) => {
            device.objects.iter().filter(|object| i64::from(object.index.0) == *index).any(|object| {
                place.subindex.is_none_or(|(first, last)| {
                    object.entries.iter().any(|entry| (first..=last).contains(&entry.address.subindex))
                })
            })
        }
        _ => device.written.0.iter().any(|it| it.place.section == place.section && it.place.key == place.key),
    }
}

/// The key below the table that no such table has; a number is one of its bits or bytes.
fn unknown_key(place: &Place) -> Option<&str> {
    let first = parts(place.path.as_deref()?).next()?;
    let is_number = matches!(CanonicalKey::of(first), CanonicalKey::Range(..));
    (!is_number && !keys(place).contains(&first)).then_some(first)
}

/// The keys that a table at a place can have.
fn keys(place: &Place) -> Vec<&'static str> {
    if place.subindex.is_some() && place.section == Section::Objects {
        raw::entry_keys()
    } else {
        raw::section_keys(place.section)
    }
}

/// The tables of the section.
fn known(device: &Device, place: &Place) -> Vec<String> {
    let same = device.written.0.iter().filter(|it| it.place.section == place.section);
    same.map(|it| it.place.to_string()).collect()
}
