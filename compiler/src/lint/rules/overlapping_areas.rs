use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::lint::overlap::overlapping;
use crate::model::{Device, Section};

rule! {
    /// An object lies in one area of the dictionary, and is listed there. Where two areas share indices, one of them does not
    /// get what it says it has.
    ///
    /// ## Fires
    /// ```toml
    /// [areas]
    /// "0x2000..=0x3FFF" = { name = "Drive" }
    /// "0x3000..=0x5FFF" = { name = "Encoder" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [areas]
    /// "0x2000..=0x2FFF" = { name = "Drive" }
    /// "0x3000..=0x5FFF" = { name = "Encoder" }
    /// ```
    pub(super) static RULE = "overlapping-areas", Dictionary, Warning, "two areas share indices";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (other, area) in overlapping(&device.areas, |area| (area.first, area.last)) {
        let message = format!("{} lies in `{}` and in `{}`", area.first, other.name, area.name);
        let diagnostic = Diagnostic::new(&RULE, message, area.origin.header(), "this area")
            .label(other.origin.header(), "and this one")
            .help("end the one where the other begins");
        let key = format!("0x{:04X}..=0x{:04X}", area.first.0, area.last.0);
        report.push(Section::Areas.at(key), diagnostic);
    }
}
