use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};
use crate::sii::checksum;

rule! {
    /// The first bytes of the EEPROM become registers of the slave controller (ETG.1000.4, ETG.1000.6): PDI control
    /// (0x140) with the configuration of the controller, PDI configuration (0x150) with that of the signals, the length
    /// of the signals, a second PDI configuration, the alias address, two reserved words and a checksum. They have to
    /// fit what else is described: a mailbox needs a processor, a signal of the clocks has to arrive there.
    ///
    /// ## Fires
    /// ```toml
    /// [sync-modes.dc]
    /// name = "DC"
    /// assign-activate = 0x300
    /// sync0 = { cycles = 1 }
    ///
    /// [objects]
    /// 0x1C32 = { name = "Outputs", type = "UINT16" }
    /// 0x1C33 = { name = "Inputs", type = "UINT16" }
    ///
    /// [eeprom]
    /// config-data = "080C02000000"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [sync-modes.dc]
    /// name = "DC"
    /// assign-activate = 0x300
    /// sync0 = { cycles = 1 }
    ///
    /// [objects]
    /// 0x1C32 = { name = "Outputs", type = "UINT16" }
    /// 0x1C33 = { name = "Inputs", type = "UINT16" }
    ///
    /// [eeprom]
    /// config-data = "080C02080000"
    /// ```
    pub(crate) static RULE = "contradicted-config-data", Output, Warning,
        "the first bytes of the EEPROM do not fit what else is described";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let bytes = &device.eeprom.config_data.0;
    let at = device.eeprom.origin.value("config-data");
    for fault in form(bytes).into_iter().chain(meaning(device, bytes)) {
        let diagnostic = Diagnostic::new(&RULE, fault, at, "the first bytes");
        report.push(Section::Eeprom.at("config-data"), diagnostic);
    }
}

/// What is wrong with the bytes alone.
fn form(bytes: &[u8]) -> Vec<String> {
    let mut faults = Vec::new();
    if !bytes.len().is_multiple_of(2) || bytes.len() > 16 {
        faults.push(format!("{} bytes are not up to eight words", bytes.len()));
    }
    if let Some([low, high]) = bytes.get(8..10)
        && (*low, *high) != (0, 0)
    {
        faults.push("word 4, the alias, would give all devices one address".to_owned());
    }
    if bytes.iter().skip(10).take(4).any(|reserved| *reserved != 0) {
        faults.push("words 5 and 6 are reserved and not 0".to_owned());
    }
    if let (Some(covered), Some(sum)) = (bytes.get(..14), bytes.get(14))
        && *sum != checksum(covered)
    {
        faults.push(format!("the checksum is 0x{:02X}, not 0x{sum:02X}", checksum(covered)));
    }
    faults
}

/// What of the bytes does not fit the mailbox and the clocks.
fn meaning(device: &Device, bytes: &[u8]) -> Vec<String> {
    let byte = |place: usize| bytes.get(place).copied();
    let mailbox = device.mailbox.is_some();
    let signal = |mask: u16| device.sync_modes.iter().any(|mode| mode.assign_activate & mask != 0);
    let routed = byte(3).unwrap_or_default();
    let faults = [
        (byte(0) == Some(0), "PDI control 0 turns the interface to the firmware off"),
        (
            byte(0) == Some(4) && mailbox,
            "PDI control 4 is digital I/O, which no firmware with a mailbox stands behind",
        ),
        (
            byte(1).is_some_and(|control| control & 1 != 0) && mailbox,
            "bit 8 of PDI control lets the controller answer for the firmware, but there is a mailbox",
        ),
        (
            byte(3).is_some() && signal(0x200) && routed & 0x0C == 0,
            "SYNC0 is used, but bits 10 and 11 of the PDI configuration let it out nowhere",
        ),
        (
            byte(3).is_some() && signal(0x400) && routed & 0xC0 == 0,
            "SYNC1 is used, but bits 14 and 15 of the PDI configuration let it out nowhere",
        ),
    ];
    faults.into_iter().filter(|(wrong, _)| *wrong).map(|(_, fault)| fault.to_owned()).collect()
}
