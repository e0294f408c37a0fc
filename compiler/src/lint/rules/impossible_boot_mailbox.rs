use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Protocol, Section};

rule! {
    /// Words 0x14 to 0x17 of the EEPROM say where the mailbox lies in the state Bootstrap (ETG.1000.6): address and size of
    /// the area that the master writes, then of the one that it reads. Both lie in the memory behind the registers, apart
    /// from each other, and have room for a file: in Bootstrap the mailbox carries FoE alone.
    ///
    /// ## Fires
    /// ```toml
    /// [mailbox]
    /// protocols = ["FoE"]
    ///
    /// [eeprom]
    /// config-data = "050E03EE0000"
    /// bootstrap = "0010 8000"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [mailbox]
    /// protocols = ["FoE"]
    ///
    /// [eeprom]
    /// config-data = "050E03EE0000"
    /// bootstrap = "0010 8000 8010 8000"
    /// ```
    pub(crate) static RULE = "impossible-boot-mailbox", Output, Warning,
        "the mailbox of Bootstrap cannot be there, or has nothing to carry";
}

/// Where the memory behind the registers begins, and where it ends.
const MEMORY: (u16, u32) = (0x1000, 0x1_0000);

/// What the shortest piece of a file takes: mailbox head, FoE head and a byte (ETG.1000.6, FoE).
const SHORTEST: u16 = 6 + 6 + 1;

pub(super) fn check(device: &Device, report: &mut Report) {
    let bytes = &device.eeprom.bootstrap.0;
    if bytes.is_empty() {
        return;
    }
    let (key, label) = ("bootstrap", "address and size from the master, then to it");
    let mut tell = |fault: String, label: &str| {
        let diagnostic = Diagnostic::new(&RULE, fault, device.eeprom.origin.value(key), label);
        report.push(Section::Eeprom.at(key), diagnostic);
    };
    match device.eeprom.boot_mailbox() {
        None => tell(format!("a mailbox has four words, and not {} bytes", bytes.len()), label),
        Some(areas) => areas_fault(areas).into_iter().for_each(|fault| tell(fault, label)),
    }
    let carries = device.mailbox.as_ref().is_some_and(|mailbox| mailbox.protocols.contains(&Protocol::Foe));
    if !carries {
        tell("in Bootstrap the mailbox carries FoE, which the device does not speak".to_owned(), "for what?");
    }
}

/// What is wrong with the areas, if anything is.
fn areas_fault(areas: [(u16, u16); 2]) -> Option<String> {
    let end = |(address, size): (u16, u16)| u32::from(address) + u32::from(size);
    let is_possible = |area: (u16, u16)| area.0 >= MEMORY.0 && end(area) <= MEMORY.1 && area.1 >= SHORTEST;
    if let Some((address, size)) = areas.into_iter().find(|area| !is_possible(*area)) {
        return Some(format!("no mailbox has {size} bytes from 0x{address:04X} on"));
    }
    let [from, to] = areas;
    let is_apart = end(from) <= to.0.into() || end(to) <= from.0.into();
    (!is_apart).then(|| {
        format!(
            "what the master writes from 0x{:04X} on and reads from 0x{:04X} on is the same",
            from.0, to.0
        )
    })
}
