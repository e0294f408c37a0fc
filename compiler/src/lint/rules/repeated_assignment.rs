use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Index, Place, Section, SyncManager};
use crate::source::{Location, Origin, Value};

rule! {
    /// A PDO is carried once. A device refuses a list that names it twice, or sends everything in it twice; and of two sync
    /// managers one has it.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "INT32"
    /// pdo = "rx"
    /// access = "rw"
    ///
    /// [rx-pdos.0x1600]
    /// name = "Setpoints"
    /// entries = ["0x2000"]
    ///
    /// [sync-managers.outputs]
    /// address = 0x1100
    /// size = 8
    /// pdos = ["0x1600", "0x1600"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "INT32"
    /// pdo = "rx"
    /// access = "rw"
    ///
    /// [rx-pdos.0x1600]
    /// name = "Setpoints"
    /// entries = ["0x2000"]
    ///
    /// [sync-managers.outputs]
    /// address = 0x1100
    /// pdos = ["0x1600"]
    /// ```
    pub(super) static RULE = "repeated-assignment", ProcessData, Error, "a PDO is assigned twice";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for manager in &device.sync_managers {
        judge(&Section::SyncManagers.at(&manager.id), &manager.origin, "pdos", report);
    }
    several(device, report);
    for configuration in &device.configurations {
        for key in ["outputs", "inputs"] {
            judge(&Section::Configurations.at(&configuration.id), &configuration.origin, key, report);
        }
    }
}

/// Judges what several sync managers carry.
fn several(device: &Device, report: &mut Report) {
    let mut first: BTreeMap<Index, &SyncManager> = BTreeMap::new();
    for manager in &device.sync_managers {
        let again = manager.pdos.iter().find_map(|pdo| Some((*pdo, *first.get(pdo)?)));
        if let Some((pdo, other)) = again {
            let message = format!("{pdo} is assigned to `{}` and to `{}`", other.id, manager.id);
            let diagnostic = Diagnostic::new(&RULE, message, manager.origin.value("pdos"), "again here")
                .label(other.origin.value("pdos"), "first here");
            report.push(Section::SyncManagers.at(&manager.id), diagnostic.help("leave one of them out"));
        }
        first.extend(manager.pdos.iter().map(|pdo| (*pdo, manager)));
    }
}

/// Judges a list of PDOs as it is written.
fn judge(at: &Place, origin: &Origin, key: &str, report: &mut Report) {
    let Some(Value::Array(items)) = origin.node(key).map(|node| &node.value) else { return };
    let mut first: BTreeMap<String, Location> = BTreeMap::new();
    for item in items.iter() {
        let Value::String(text) = &item.value else { continue };
        // an index is the same in capitals
        let Some(other) = first.get(&text.to_ascii_lowercase()) else {
            first.insert(text.to_ascii_lowercase(), item.at);
            continue;
        };
        let message = format!("{text} is assigned twice");
        let diagnostic = Diagnostic::new(&RULE, message, item.at, "again here").label(*other, "first here");
        report.push(at.clone(), diagnostic.help("leave one of them out"));
    }
}
