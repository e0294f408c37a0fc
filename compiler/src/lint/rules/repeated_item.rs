use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Document, Place, Section};
use crate::source::Location;

rule! {
    /// A list that names one thing twice, be it in two spellings, has an item that was meant to be another one. Outputs say
    /// it twice: an ESI has a module twice in a slot, of which a tool refuses one. So it is with tables in a list: of two
    /// properties of one name a tool takes one.
    ///
    /// ## Fires
    /// ```toml
    /// [slots.place]
    /// name = "Place"
    /// max = 1
    /// modules = [0x100, 256]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [slots.place]
    /// name = "Place"
    /// max = 1
    /// modules = [0x100, 0x256]
    /// ```
    pub(super) static RULE = "repeated-item", Facts, Warning, "a list names one thing twice";
}

/// The lists in which one thing twice means something, or which another rule judges.
const OTHERS: &[(&str, &str)] = &[
    ("steps", "one can be done again"),
    ("data", "it is bytes"),
    ("outputs", "`repeated-assignment` judges it"),
    ("inputs", "`repeated-assignment` judges it"),
    ("pdos", "`repeated-assignment` judges it"),
    ("aliases", "`repeated-alias` judges it"),
];

pub(super) fn check(device: &Device, report: &mut Report) {
    for slip in &*report.slips(device) {
        let Some(item) = &slip.twice else { continue };
        if OTHERS.iter().any(|(name, _)| *name == slip.key) {
            continue;
        }
        report.push(slip.place.clone(), finding(&slip.key, item, slip.at));
    }
    tables(device, report);
}

fn finding(list: &str, item: &str, [second, first]: [Location; 2]) -> Diagnostic {
    Diagnostic::new(&RULE, format!("`{list}` names `{item}` twice"), second, "again here")
        .label(first, "first here")
        .help("leave one of them out, or name what was meant")
}

/// The lists whose tables say first what they are about.
fn tables(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let names = entry.properties.iter().enumerate();
        let names = names.map(|(i, it)| (&*it.name, entry.origin.value(&format!("properties.{i}.name"))));
        judge(&lookup::name(object, entry).at("properties"), "properties", names, report);
    }
    for method in &device.homing_methods {
        let cases = method.alternatives.iter().enumerate();
        let cases = cases.map(|(i, it)| (&*it.when, method.origin.value(&format!("alternatives.{i}.when"))));
        judge(&Section::HomingMethods.at(method.number), "alternatives", cases, report);
    }
    let actions = device.stop_options.iter().map(|it| (&*it.action, it.origin.value("action")));
    judge(&Section::StopOptions.into(), "stop-options", actions, report);
    let documents: Vec<_> =
        device.documents.iter().map(|it| (edition(it), it.origin.value("title"))).collect();
    let documents = documents.iter().map(|(text, at)| (&**text, *at));
    judge(&Section::Documents.into(), "documents", documents, report);
    let remarks: Vec<_> = device
        .remarks
        .iter()
        .map(|it| (format!("{}: {}", it.at, it.text), it.origin.value("text")))
        .collect();
    judge(&Section::Remarks.into(), "remarks", remarks.iter().map(|(text, at)| (&**text, *at)), report);
}

/// What tells a document from others: of one title there can be several editions, and parts with numbers of their own.
fn edition(document: &Document) -> String {
    let parts = [&document.number, &document.edition, &document.publisher].into_iter().flatten();
    [&document.title].into_iter().chain(parts).map(|part| part.as_str()).collect::<Vec<_>>().join(", ")
}

fn judge<'d>(at: &Place, list: &str, names: impl Iterator<Item = (&'d str, Location)>, report: &mut Report) {
    let mut known: BTreeMap<String, Location> = BTreeMap::new();
    for (name, place) in names {
        let key = name.trim().to_lowercase();
        match known.get(&key) {
            Some(first) => report.push(at.clone(), finding(list, name, [place, *first])),
            None => {
                known.insert(key, place);
            }
        }
    }
}
