use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, images};
use crate::model::{Device, Pdo};
use crate::source::Location;

rule! {
    /// PDOs that exclude each other cannot be assigned together. If the default assignment does so, the device
    /// does not start with the settings that its own ESI file gives a master; a configuration that does so is refused.
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
    for image in images::images(device) {
        let Some(assigned) = image.assigned() else { continue };
        for (i, second) in image.pdos.iter().enumerate() {
            for first in image.pdos.iter().take(i) {
                if let Some(diagnostic) = judge(first, second, assigned) {
                    let help = match image.configuration {
                        Some(_) => "choose one of them",
                        None => "assign one of them by default; a master can choose the other",
                    };
                    report.push(image.place(), diagnostic.help(help));
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
    Some(diagnostic)
}
