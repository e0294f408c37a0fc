use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Pdo, Section};
use crate::source::Location;

rule! {
    /// PDOs that exclude each other cannot be assigned together. If the default assignment does so, the device
    /// does not start with the settings that its own ESI file gives a master.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [objects.0x2001]
    /// name = "Torque"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos]
    /// 0x1A00 = { name = "Speed", entries = ["0x2000"], excludes = ["0x1A01"] }
    /// 0x1A01 = { name = "Torque", entries = ["0x2001"], excludes = ["0x1A00"] }
    ///
    /// [sync-managers.inputs]
    /// address = 0x1400
    /// pdos = ["0x1A00", "0x1A01"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [objects.0x2001]
    /// name = "Torque"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos]
    /// 0x1A00 = { name = "Speed", entries = ["0x2000"], excludes = ["0x1A01"] }
    /// 0x1A01 = { name = "Torque", entries = ["0x2001"], excludes = ["0x1A00"] }
    ///
    /// [sync-managers.inputs]
    /// address = 0x1400
    /// pdos = ["0x1A00"]
    /// ```
    pub(super) static RULE = "excluded-assignment", ProcessData, Error,
        "PDOs that exclude each other are assigned together";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for manager in &device.sync_managers {
        let pdos: Vec<&Pdo> = manager.pdos.iter().filter_map(|index| device.pdo(*index)).collect();
        for (i, second) in pdos.iter().enumerate() {
            for first in pdos.iter().take(i) {
                if let Some(diagnostic) = judge(first, second, manager.origin.value("pdos")) {
                    report.push(Section::SyncManagers.at(&manager.id), diagnostic);
                }
            }
        }
    }
}

fn judge(first: &Pdo, second: &Pdo, assigned: Location) -> Option<Diagnostic> {
    let excludes = |one: &Pdo, other: &Pdo| one.excludes.contains(&other.index);
    let pairs = [(first, second), (second, first)];
    let saying: Vec<_> = pairs.into_iter().filter(|(one, other)| excludes(one, other)).collect();
    let what = match saying.as_slice() {
        [] => return None,
        [(one, other)] => format!("{} excludes {}", one.index, other.index),
        _ => "exclude each other".to_owned(),
    };
    let message = format!("{} and {} are assigned together, but {what}", first.index, second.index);
    let mut diagnostic = Diagnostic::new(&RULE, message, assigned, "assigned together");
    for (one, other) in saying {
        let label = format!("{} excludes {}", one.index, other.index);
        diagnostic = diagnostic.label(one.origin.value("excludes"), label);
    }
    Some(diagnostic.help("assign one of them by default; a master can choose the other"))
}
