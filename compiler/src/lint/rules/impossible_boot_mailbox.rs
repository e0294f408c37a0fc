use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// Words 0x14 to 0x17 of the EEPROM say where the mailbox lies in the state Bootstrap (ETG.1000.6): address and size of
    /// the area that the master writes, then of the one that it reads. Both lie in the memory behind the registers.
    ///
    /// ## Fires
    /// ```toml
    /// [eeprom]
    /// config-data = "050E03EE0000"
    /// bootstrap = "0010 8000"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [eeprom]
    /// config-data = "050E03EE0000"
    /// bootstrap = "0010 8000 8010 8000"
    /// ```
    pub(crate) static RULE = "impossible-boot-mailbox", Output, Warning,
        "no mailbox can lie where Bootstrap has it";
}

/// Where the memory behind the registers begins.
const MEMORY: u16 = 0x1000;

pub(super) fn check(device: &Device, report: &mut Report) {
    let bytes = &device.eeprom.bootstrap.0;
    let is_possible = |(address, size): (u16, u16)| address >= MEMORY && size > 0;
    let fault = match device.eeprom.boot_mailbox() {
        _ if bytes.is_empty() => return,
        None => format!("a mailbox has four words, and not {} bytes", bytes.len()),
        Some(areas) => match areas.into_iter().find(|area| !is_possible(*area)) {
            Some((address, size)) => format!("no mailbox has {size} bytes from 0x{address:04X} on"),
            None => return,
        },
    };
    let at = device.eeprom.origin.value("bootstrap");
    let label = "address and size from the master, then to it";
    report.push(Section::Eeprom.at("bootstrap"), Diagnostic::new(&RULE, fault, at, label));
}
