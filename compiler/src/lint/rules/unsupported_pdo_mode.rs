use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// A PDO that is made for a mode of operation is of no use in a device without that mode; often it is left
    /// over from a related device.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x6040]
    ///
    /// [rx-pdos.0x1600]
    /// name = "Profile position"
    /// mode = 1
    /// entries = ["controlword"]
    ///
    /// [modes.0]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x6040]
    ///
    /// [rx-pdos.0x1600]
    /// name = "No mode"
    /// mode = 0
    /// entries = ["controlword"]
    ///
    /// [modes.0]
    /// ```
    pub(super) static RULE = "unsupported-pdo-mode", ProcessData, Warning,
        "a PDO is meant for a mode that the device does not have";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    if device.modes.is_empty() {
        return;
    }
    let known = |code: i16| device.modes.iter().any(|mode| mode.code == code || mode.aliases.contains(&code));
    for pdo in &device.pdos {
        let Some(code) = pdo.mode.filter(|code| !known(*code)) else { continue };
        let modes = lookup::all("mode", device.modes.iter().map(|mode| mode.code));
        let message = format!("{} is for mode {code}, which the device does not have", pdo.index);
        let diagnostic = Diagnostic::new(&RULE, message, pdo.origin.value("mode"), "no such mode");
        report.push(pdo.index, diagnostic.note(modes));
    }
}
