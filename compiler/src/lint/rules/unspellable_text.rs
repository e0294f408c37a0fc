use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Place, Section};
use crate::source::Origin;

rule! {
    /// A STRING of Structured Text has 80 characters of one byte each, of Latin 1. A longer name of an error is cut where it is
    /// shown, and other characters are question marks.
    ///
    /// ## Fires
    /// ```toml
    /// [errors.0x7305]
    /// name = "Angle \u03C6 is out of range"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [errors.0x7305]
    /// name = "Angle is out of range"
    /// ```
    pub(crate) static RULE = "unspellable-text", Output, Warning,
        "the name of an error does not fit into a STRING of Structured Text";
}

/// The characters of a STRING whose length is not said.
const LONGEST: usize = 80;

pub(super) fn check(device: &Device, report: &mut Report) {
    let errors = device.errors.iter().map(|it| (it.place(), it.name.as_str(), &it.origin));
    let codes = device.al_status_codes.iter();
    let codes = codes.map(|it| (Section::AlStatusCodes.at(it.code), it.name.as_str(), &it.origin));
    let named: Vec<(Place, &str, &Origin)> = errors.chain(codes).collect();
    for (place, name, origin) in named {
        let length = name.chars().count();
        let message = match name.chars().find(|c| *c > '\u{FF}') {
            Some(c) => format!("`{c}` is not in Latin 1"),
            None if length > LONGEST => format!("the name has {length} characters; {LONGEST} fit"),
            None => continue,
        };
        let diagnostic = Diagnostic::new(&RULE, message, origin.value("name"), "does not fit into a STRING");
        report.push(place, diagnostic);
    }
}
