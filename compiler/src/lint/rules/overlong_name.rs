use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, texts};
use crate::model::Device;

rule! {
    /// A tool that makes the EEPROM image from an ESI file puts the names of device, PDOs and ways to
    /// synchronise into strings of 255 bytes at most. A longer one is cut, or the image is refused.
    ///
    /// ## Fires
    /// ```toml
    /// [device]
    /// name = "Example"
    /// vendor = "Example"
    /// group = """
    /// Drives for everything that moves, be it in a line or in a circle, fast or slow, light or heavy, up or \
    /// down, near or far, in the light or in the dark, in the heat or in the cold, on the ground or under \
    /// water, alone or together with any number of others of its kind"""
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [device]
    /// name = "Example"
    /// vendor = "Example"
    /// group = "Drives"
    /// ```
    pub(crate) static RULE = "overlong-name", Output, Warning, "a name does not fit into an EEPROM";
}

/// The length of a string in an EEPROM is one byte.
const LONGEST: usize = 255;

pub(super) fn check(device: &Device, report: &mut Report) {
    for text in texts::names(device).filter(|text| text.text.len() > LONGEST) {
        let message = format!("the name of {} has {} bytes; 255 fit", text.at, text.text.len());
        report.push(text.at, Diagnostic::new(&RULE, message, text.place, "too long for an EEPROM"));
    }
}
