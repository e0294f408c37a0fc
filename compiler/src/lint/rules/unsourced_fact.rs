use std::collections::{BTreeMap, BTreeSet};

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Source};
use crate::source::Location;

rule! {
    /// Where most facts of a kind say where they are from, one that does not was forgotten, or is made up. What no
    /// source states is marked as `assumed`.
    ///
    /// ## Fires
    /// ```toml
    /// [objects]
    /// 0x2000 = { name = "Speed", type = "UINT16", source = "p. 4" }
    /// 0x2001 = { name = "Torque", type = "UINT16", source = "p. 4" }
    /// 0x2002 = { name = "Power", type = "UINT16" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects]
    /// 0x2000 = { name = "Speed", type = "UINT16", source = "p. 4" }
    /// 0x2001 = { name = "Torque", type = "UINT16", source = "p. 4" }
    /// 0x2002 = { name = "Power", type = "UINT16", assumed = "speed and torque make power" }
    /// ```
    pub(super) static RULE = "unsourced-fact", Facts, Warning, "a fact has no source where its siblings have one";
}

/// A fact: the table it is in, its name, whether it has a source, and where it stands.
type Fact = (&'static str, String, bool, Location);

pub(super) fn check(device: &Device, report: &mut Report) {
    let assumed: BTreeSet<&str> = device.assumptions.iter().map(|it| it.at.as_str()).collect();
    let facts = facts(device);
    let mut counts: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
    for (table, _, sourced, _) in &facts {
        let count = counts.entry(table).or_default();
        *if *sourced { &mut count.0 } else { &mut count.1 } += 1;
    }
    for (table, at, _, place) in facts.iter().filter(|(_, at, sourced, _)| !sourced && !assumed.contains(&**at)) {
        let (with, without) = counts.get(table).copied().unwrap_or_default();
        if with > without {
            let message = format!("{at} has no source, but {with} others in `[{table}]` have");
            let diagnostic = Diagnostic::new(&RULE, message, *place, "no `source`")
                .help("write where it is from, or `assumed = \"...\"` with the reason");
            report.push(at, diagnostic);
        }
    }
}

fn facts(device: &Device) -> Vec<Fact> {
    let mut facts = Vec::new();
    let mut add = |table: &'static str, at: String, source: &Option<Source>, place: Location| {
        facts.push((table, at, source.is_some(), place));
    };
    for it in lookup::objects(device) {
        add("objects", it.index.to_string(), &it.source, it.origin.header());
    }
    for it in &device.pdos {
        let table = if it.direction == crate::model::Direction::Rx { "rx-pdos" } else { "tx-pdos" };
        add(table, it.index.to_string(), &it.source, it.origin.header());
    }
    for it in &device.words {
        add("words", format!("words.{}", it.id), &it.source, it.origin.header());
    }
    for it in &device.states {
        add("states", format!("states.{}", it.id), &it.source, it.origin.header());
    }
    for it in &device.commands {
        add("commands", format!("commands.{}", it.id), &it.source, it.origin.header());
    }
    for it in &device.transitions {
        add("transitions", format!("transitions.{}", it.number), &it.source, it.origin.header());
    }
    for it in &device.modes {
        add("modes", format!("modes.{}", it.code), &it.source, it.origin.header());
    }
    for it in &device.errors {
        add("errors", format!("errors.0x{:04X}", it.code), &it.source, it.origin.header());
    }
    for it in &device.units {
        add("units", format!("units.{}", it.id), &it.source, it.origin.header());
    }
    facts
}
