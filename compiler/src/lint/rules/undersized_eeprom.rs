use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Direction, Pdo, Section};

rule! {
    /// A tool writes to the EEPROM what the ESI says of names, sync managers, PDOs and clocks (ETG.1000.6, SII). Where that
    /// does not fit, it leaves the PDOs out, and a master that starts from the EEPROM finds no process data.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT32"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    ///
    /// [eeprom]
    /// size = 256
    /// config-data = "050E03EE0000"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT32"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    ///
    /// [eeprom]
    /// size = 512
    /// config-data = "050E03EE0000"
    /// ```
    pub(super) static RULE = "undersized-eeprom", Output, Warning,
        "what an ESI says does not fit into the EEPROM";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let (size, needs) = (device.eeprom.size, needs(device));
    let stated = device.eeprom.origin.has("size") && device.eeprom.is_possible();
    if stated && usize::try_from(size).is_ok_and(|size| size < needs) {
        let message = format!("the EEPROM has {size} bytes, but what is described takes {needs}");
        let diagnostic = Diagnostic::new(&RULE, message, device.eeprom.origin.value("size"), "too short")
            .note("it has 128 bytes of its own, names, general information, sync managers, PDOs and clocks");
        report.push(Section::Eeprom.at("size"), diagnostic);
    }
}

/// The bytes in front of the categories, those of a category's head, and those of the mark behind the last one.
const FIXED: usize = 128;
const HEAD: usize = 4;
const END: usize = 2;

/// The bytes that the image of an EEPROM takes with all that is described.
fn needs(device: &Device) -> usize {
    let general = HEAD + 32;
    let mapping_units = HEAD + 4;
    let sync_managers = HEAD + 8 * device.sync_managers.len();
    let clocks = if device.sync_modes.is_empty() { 0 } else { HEAD + 24 * device.sync_modes.len() };
    let pdos = [Direction::Rx, Direction::Tx].map(|way| pdos(device, way)).iter().sum::<usize>();
    FIXED + strings(device) + general + mapping_units + sync_managers + pdos + clocks + END
}

/// One category for all PDOs of a direction: 8 bytes for each, and 8 for each of its entries.
fn pdos(device: &Device, way: Direction) -> usize {
    let bytes = |pdo: &Pdo| 8 + 8 * pdo.entries.len();
    let pdos: usize = device.pdos_of(way).map(bytes).sum();
    if pdos == 0 { 0 } else { HEAD + pdos }
}

/// All names, each once with its length before it.
fn strings(device: &Device) -> usize {
    let mut names: BTreeSet<&str> = BTreeSet::from([&*device.type_name, &*device.name, &*device.group]);
    names.extend(device.sync_modes.iter().map(|mode| &*mode.id));
    for pdo in &device.pdos {
        names.insert(&pdo.name);
        names.extend(pdo.entries.iter().filter(|entry| entry.address.is_some()).map(|entry| &*entry.name));
    }
    let bytes: usize = names.iter().map(|name| 1 + name.len()).sum();
    HEAD + (1 + bytes).next_multiple_of(2)
}
