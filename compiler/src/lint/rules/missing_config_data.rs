use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// An EEPROM begins with what the slave controller needs to start: how it speaks with the firmware, how long its
    /// signals are. An ESI has these bytes, and readers miss them (ETG.2000). Without them, a tool that writes the EEPROM
    /// of a new device can only turn that interface off; devc makes none up, and so no image of the EEPROM.
    ///
    /// Only a device that a master can reach is asked for them: one with sync managers.
    ///
    /// ## Fires
    /// ```toml
    /// [sync-managers]
    /// inputs = { address = 0x1100 }
    ///
    /// [eeprom]
    /// size = 2048
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [sync-managers]
    /// inputs = { address = 0x1100 }
    ///
    /// [eeprom]
    /// size = 2048
    /// config-data = "050E03EE0000"
    /// ```
    pub(crate) static RULE = "missing-config-data", Output, Warning,
        "the first bytes of the EEPROM are not described";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    if device.sync_managers.is_empty() || !device.eeprom.config_data.0.is_empty() {
        return;
    }
    let (at, label) = match device.eeprom.is_described() {
        true => (device.eeprom.origin.header(), "no `config-data`"),
        false => (device.origin.header(), "no `[eeprom]`"),
    };
    let message = "an ESI needs the first bytes of the EEPROM".to_owned();
    let diagnostic = Diagnostic::new(&RULE, message, at, label)
        .note("without them there is no image of the EEPROM: a wrong byte can turn the interface to the firmware off");
    let help = "add `config-data` to `[eeprom]`: PDI control and what follows, as the firmware's tool or the EEPROM of a \
                device has it";
    report.push(Section::Eeprom.at("config-data"), diagnostic.help(help));
}
