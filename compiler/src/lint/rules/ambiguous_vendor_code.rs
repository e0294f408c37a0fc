use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// A code of the vendor's own system that belongs to two error codes cannot be translated back: whoever
    /// reads it in a log does not know which error it was.
    ///
    /// ## Fires
    /// ```toml
    /// [errors.0x7121]
    /// name = "Motor blocked"
    /// vendor-codes = [657]
    ///
    /// [errors.0xFF50]
    /// name = "Safety stop"
    /// vendor-codes = [500, 657]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [errors.0x7121]
    /// name = "Motor blocked"
    /// vendor-codes = [657]
    ///
    /// [errors.0xFF50]
    /// name = "Safety stop"
    /// vendor-codes = [500]
    /// ```
    pub(super) static RULE = "ambiguous-vendor-code", Values, Warning,
        "a vendor code stands for two errors";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut first = BTreeMap::new();
    for error in &device.errors {
        for (i, code) in error.vendor_codes.iter().enumerate() {
            let at = error.origin.value(&format!("vendor-codes.{i}"));
            let Some((other, place)) = first.get(code) else {
                first.insert(*code, (error.code, at));
                continue;
            };
            if *other == error.code {
                continue;
            }
            let message = format!("vendor code {code} stands for 0x{other:04X} and 0x{:04X}", error.code);
            let diagnostic = Diagnostic::new(&RULE, message, at, format!("for 0x{:04X} here", error.code))
                .label(*place, format!("for 0x{other:04X} here"));
            report.push(Section::VendorCodes.at(code), diagnostic);
        }
    }
}
