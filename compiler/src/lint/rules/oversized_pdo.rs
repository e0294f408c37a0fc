use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Pdo, Place, Section};
use crate::source::Location;

rule! {
    /// A device refuses a mapping that is longer than it can carry.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT64"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// max-bytes = 4
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT64"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// max-bytes = 8
    /// ```
    pub(super) static RULE = "oversized-pdo", ProcessData, Error,
        "a PDO is longer than the device can carry";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for pdo in &device.pdos {
        check_pdo(pdo, &pdo.index.into(), pdo.origin.value("entries"), report);
    }
    for configuration in &device.configurations {
        for pdo in &configuration.mapping {
            let at = configuration.origin.value(&format!("mapping.{}", pdo.leading));
            let place = Section::Configurations.at(&configuration.id).at(format!("mapping.{}", pdo.index));
            check_pdo(pdo, &place, at, report);
        }
    }
}

fn check_pdo(pdo: &Pdo, place: &Place, mapped: Location, report: &mut Report) {
    let entries = u32::try_from(pdo.entries.len()).unwrap_or(u32::MAX);
    let limits = [
        ("max-bytes", pdo.bytes(), pdo.max_bytes.map(u32::from), "bytes"),
        ("max-entries", entries, pdo.max_entries.map(u32::from), "entries"),
    ];
    for (key, has, max, what) in limits {
        let Some(max) = max.filter(|max| has > *max) else { continue };
        let message = format!("{} has {has} {what}, but the device takes {max}", pdo.index);
        let diagnostic = Diagnostic::new(&RULE, message, mapped, format!("{has} {what}"));
        report.push(place.clone(), diagnostic.label(pdo.origin.value(key), "the limit"));
    }
}
