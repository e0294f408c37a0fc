use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Place, Section};
use crate::source::Location;

rule! {
    /// Programs know things by identifiers made of letters, digits and `_`. Two ids that differ in nothing else become
    /// one identifier; the second gets a number behind it, which changes as soon as a third comes in between.
    ///
    /// ## Fires
    /// ```toml
    /// [commands]
    /// "stand-by" = { name = "Stand-by", pattern = "x0" }
    /// "stand_by" = { name = "Ready", pattern = "x1" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [commands]
    /// "stand-by" = { name = "Stand-by", pattern = "x0" }
    /// "ready" = { name = "Ready", pattern = "x1" }
    /// ```
    pub(crate) static RULE = "clashing-identifier", Output, Warning, "two ids make one identifier";
}

/// What has an identifier: the table it is in, its key there, its id, its name, and where it stands.
type Named<'d> = (Place, &'d str, &'d str, Location);

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut first = BTreeMap::new();
    for (subject, id, name, place) in named(device) {
        let table = subject.section;
        let Some((other, its_name, at)) = first.get(&(table, identifier(id))) else {
            first.insert((table, identifier(id)), (id, name, place));
            continue;
        };
        // Two objects of one name are a fault of their own, from which this follows.
        if table == Section::Objects && name.eq_ignore_ascii_case(its_name) {
            continue;
        }
        let message = format!("`{other}` and `{id}` are both `{}` in a program", identifier(id));
        let diagnostic = Diagnostic::new(&RULE, message, place, "gets a number behind it")
            .label(*at, "has the identifier");
        report.push(subject, diagnostic);
    }
}

fn named(device: &Device) -> Vec<Named<'_>> {
    let mut named = Vec::new();
    for it in lookup::objects(device).filter(|object| object.axis.is_none_or(|axis| axis == 0)) {
        named.push((it.index.into(), &*it.id, &*it.name, it.origin.header()));
    }
    for it in &device.words {
        named.push((Section::Words.at(&it.id), &it.id, &it.name, it.origin.header()));
    }
    for it in &device.states {
        named.push((Section::States.at(&it.id), &it.id, &it.name, it.origin.header()));
    }
    for it in &device.commands {
        named.push((Section::Commands.at(&it.id), &it.id, &it.name, it.origin.header()));
    }
    for it in &device.modes {
        named.push((Section::Modes.at(it.code), &it.id, &it.name, it.origin.header()));
    }
    for it in &device.units {
        named.push((Section::Units.at(&it.id), &it.id, &it.quantity, it.origin.header()));
    }
    for (i, axis) in device.axes.iter().enumerate() {
        let at = format!("names.{i}");
        named.push((Section::Axes.at(&at), &axis.name, &axis.name, device.arrangement.origin.value(&at)));
    }
    named
}

/// The runs of letters and digits, as identifiers have them.
fn identifier(id: &str) -> String {
    let words = id.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_ascii_lowercase).collect::<Vec<_>>().join("_")
}
