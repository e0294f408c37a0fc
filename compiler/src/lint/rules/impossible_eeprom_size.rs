use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Eeprom, Section};

rule! {
    /// The EEPROM says its own size in units of 1 KiBit, 128 bytes, of which it has one at least; a slave controller
    /// reads 4 MiBit at most (ETG.1000.6).
    ///
    /// ## Fires
    /// ```toml
    /// [eeprom]
    /// size = 100
    /// config-data = "050E03EE0000"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [eeprom]
    /// size = 1920
    /// config-data = "050E03EE0000"
    /// ```
    pub(crate) static RULE = "impossible-eeprom-size", Output, Warning,
        "no EEPROM has this size";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    if device.eeprom.is_possible() {
        return;
    }
    let message = format!("no EEPROM has {} bytes", device.eeprom.size);
    let label = format!("a multiple of {}, {} at most", Eeprom::UNIT, Eeprom::MOST);
    let diagnostic = Diagnostic::new(&RULE, message, device.eeprom.origin.value("size"), label);
    report.push(Section::Eeprom.at("size"), diagnostic);
}
