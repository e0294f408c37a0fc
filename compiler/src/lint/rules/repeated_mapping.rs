use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, images};
use crate::model::Device;

rule! {
    /// An object that is twice in what a master sends has two values in the same cycle, and which one counts is
    /// open; twice in what a device sends it takes bytes for nothing.
    ///
    /// The PDOs that are assigned by default are looked at together, and those of each configuration.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "rw"
    /// pdo = "rx"
    ///
    /// [rx-pdos]
    /// 0x1600 = { name = "Setpoints", entries = ["0x2000"] }
    /// 0x1601 = { name = "More setpoints", entries = ["0x2000"] }
    ///
    /// [sync-managers.outputs]
    /// address = 0x1100
    /// pdos = ["0x1600", "0x1601"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// access = "rw"
    /// pdo = "rx"
    ///
    /// [rx-pdos]
    /// 0x1600 = { name = "Setpoints", entries = ["0x2000"] }
    /// 0x1601 = { name = "More setpoints", entries = ["0x2000"] }
    ///
    /// [sync-managers.outputs]
    /// address = 0x1100
    /// pdos = ["0x1600"]
    /// ```
    pub(super) static RULE = "repeated-mapping", ProcessData, Warning,
        "an object is twice in a process image";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for image in images::images(device) {
        let mut first = BTreeMap::new();
        for (pdo, at, mapped) in image.mapped() {
            let Some(address) = mapped.address else { continue };
            let Some((other, place)) = first.get(&address) else {
                first.insert(address, (pdo.index, mapped.origin.header()));
                continue;
            };
            let when = match image.configuration {
                Some(configuration) => format!("assigned together by `{}`", configuration.id),
                None => "both assigned by default".to_owned(),
            };
            let message = match *other == pdo.index {
                true => format!("{address} is twice in {other}"),
                false => format!("{address} is in {other} and in {}, {when}", pdo.index),
            };
            let diagnostic = Diagnostic::new(&RULE, message, mapped.origin.header(), "again here");
            report.push(at, diagnostic.label(*place, "first here"));
        }
    }
}
