use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Section};

rule! {
    /// A configuration that sets a mode of operation which the device does not have ends in an abort of the SDO
    /// or in a drive that does not follow its set values.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects]
    /// 0x6060 = {}
    /// 0x6061 = {}
    /// 0x6502 = {}
    ///
    /// [modes.6]
    ///
    /// [configurations.positioning]
    /// name = "Positioning"
    /// mode = 1
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects]
    /// 0x6060 = {}
    /// 0x6061 = {}
    /// 0x6502 = {}
    ///
    /// [modes.6]
    ///
    /// [configurations.homing]
    /// name = "Homing"
    /// mode = 6
    /// ```
    pub(super) static RULE = "unsupported-configuration-mode", ProcessData, Warning,
        "a configuration sets a mode that the device does not have";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    if device.modes.is_empty() {
        return;
    }
    let known = |code: i16| device.modes.iter().any(|mode| mode.code == code || mode.aliases.contains(&code));
    for configuration in &device.configurations {
        let Some(code) = configuration.mode.filter(|code| !known(*code)) else { continue };
        let message = format!("`{}` sets mode {code}, which the device does not have", configuration.name);
        let modes = lookup::all("mode", device.modes.iter().map(|mode| mode.code));
        let diagnostic =
            Diagnostic::new(&RULE, message, configuration.origin.value("mode"), "no such mode").note(modes);
        report.push(Section::Configurations.at(&configuration.id), diagnostic);
    }
}
