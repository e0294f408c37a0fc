use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// A PDO can only carry what is in the object dictionary. If the manual maps an object that its own
    /// dictionary does not list, either the mapping is left over from another device or the object is not
    /// documented; nobody can tell what its bytes mean.
    ///
    /// ## Fires
    /// ```toml
    /// [rx-pdos.0x1600]
    /// name = "Setpoints"
    /// entries = [{ entry = "0x6081:00", bits = 32, name = "Profile velocity" }]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x6081]
    /// name = "Profile velocity"
    /// type = "UINT32"
    /// access = "rw"
    /// pdo = "rx"
    ///
    /// [rx-pdos.0x1600]
    /// name = "Setpoints"
    /// entries = [{ entry = "0x6081:00", bits = 32, name = "Profile velocity" }]
    /// ```
    pub(super) static RULE = "absent-mapped-entry", ProcessData, Warning,
        "a PDO maps what the dictionary does not have";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (pdo, at, mapped) in lookup::mapped(device) {
        let Some(address) = mapped.address.filter(|address| device.entry(*address).is_none()) else {
            continue;
        };
        let message = format!("{} maps {address}, which is not in the dictionary", pdo.index);
        let label = match device.object(address.index) {
            Some(object) => format!("{} ends at subindex {}", object.index, object.highest_subindex()),
            None => format!("there is no object {}", address.index),
        };
        let diagnostic = Diagnostic::new(&RULE, message, mapped.origin.header(), label);
        report.push(at, diagnostic.help("describe the object, or take it out of the PDO"));
    }
}
