use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::Device;

rule! {
    /// A PDO that excludes itself could never be assigned; one that is excluded twice was perhaps meant to be another.
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
    /// excludes = ["0x1600"]
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
    /// excludes = ["0x1601"]
    ///
    /// [rx-pdos.0x1601]
    /// name = "Other setpoints"
    /// entries = ["0x2000"]
    /// excludes = ["0x1600"]
    /// ```
    pub(super) static RULE = "pointless-exclusion", ProcessData, Warning,
        "a PDO excludes itself, or another one twice";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for pdo in &device.pdos {
        let twice = pdo.excludes.windows(2).find_map(|pair| match pair {
            // they are sorted
            [one, other] if one == other => Some(format!("{} excludes {one} twice", pdo.index)),
            _ => None,
        });
        let own = pdo.excludes.contains(&pdo.index).then(|| format!("{} excludes itself", pdo.index));
        for message in own.into_iter().chain(twice) {
            let place = pdo.origin.value("excludes");
            report.push(pdo.index, Diagnostic::new(&RULE, message, place, "the list"));
        }
    }
}
