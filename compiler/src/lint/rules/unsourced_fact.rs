use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

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

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut sourced: BTreeMap<Section, (usize, usize)> = BTreeMap::new();
    for table in &device.written.0 {
        let (with, without) = sourced.entry(table.place.section).or_default();
        *if table.sourced { with } else { without } += 1;
    }
    for table in device.written.0.iter().filter(|table| !table.sourced && !table.assumed) {
        let (with, without) = sourced.get(&table.place.section).copied().unwrap_or_default();
        if with > without {
            let at = &table.place;
            let section = at.section.name();
            let message = format!("{at} has no source, but {with} others in `[{section}]` have");
            let diagnostic = Diagnostic::new(&RULE, message, table.origin.header(), "no `source`")
                .help("write where it is from, or `assumed = \"...\"` with the reason");
            report.push(at.clone(), diagnostic);
        }
    }
}
