use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};
use crate::sii::{Extent, bytes, fitting};

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
    pub(crate) static RULE = "undersized-eeprom", Output, Warning,
        "what an ESI says does not fit into the EEPROM";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let (eeprom, fitting) = (&device.eeprom, fitting(device));
    // Of a size that nobody states, it is worth a word only that there is no image.
    let told = eeprom.origin.has("size") || fitting.is_none() && !eeprom.config_data.0.is_empty();
    if !told || !eeprom.is_possible() || fitting == Some(Extent::All) {
        return;
    }
    let (size, needs) = (eeprom.size, bytes(device, Extent::All));
    let message = format!("the EEPROM has {size} bytes, but what is described takes {needs}");
    let left = match fitting {
        Some(_) => "the image of it has only the PDOs that are assigned at start-up, which fit",
        None => "there is no image of it, since not even the PDOs fit that are assigned at start-up",
    };
    let diagnostic = Diagnostic::new(&RULE, message, eeprom.origin.value("size"), "too short")
        .note("it has 128 bytes of its own, 255 names at most, general information, sync managers, PDOs and clocks")
        .note(left);
    report.push(Section::Eeprom.at("size"), diagnostic);
}
