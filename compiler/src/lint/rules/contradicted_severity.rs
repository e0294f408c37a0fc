use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, ErrorCode, VendorCode};

rule! {
    /// An error and the vendor's own codes for it are one fault of the drive. If both say how bad it is, or whether it can be
    /// reset, and not the same, one of them is wrong; or the error code stands for several faults that differ in this, and then
    /// only the vendor's codes can say it.
    ///
    /// ## Fires
    /// ```toml
    /// [errors]
    /// 0x2310 = { name = "Overcurrent", vendor-codes = [101], severity = "error" }
    ///
    /// [vendor-codes]
    /// 101 = { name = "Overcurrent of the motor", severity = "warning" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [errors]
    /// 0x2310 = { name = "Overcurrent", vendor-codes = [101], severity = "warning" }
    ///
    /// [vendor-codes]
    /// 101 = { name = "Overcurrent of the motor", severity = "warning" }
    /// ```
    pub(super) static RULE = "contradicted-severity", Values, Warning,
        "an error and the vendor's code for it are not equally bad";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let codes: BTreeMap<u32, &VendorCode> =
        device.vendor_codes.iter().map(|code| (code.code, code)).collect();
    for error in &device.errors {
        for (key, of_error, of_code) in FACTS {
            let Some(own) = of_error(error) else { continue };
            let named = error.vendor_codes.iter().filter_map(|code| codes.get(code).copied());
            let other =
                named.filter_map(|code| Some((code, of_code(code)?))).find(|(_, other)| *other != own);
            let Some((code, other)) = other else { continue };
            let message =
                format!("`{}` has {key} {own}, its vendor code {} has {other}", error.name, code.code);
            let diagnostic = Diagnostic::new(&RULE, message, error.origin.value(key), "of the error")
                .label(code.origin.value(key), "of the vendor's code")
                .help("correct the one that is wrong, or leave it to the vendor's codes if they differ");
            report.push(error.place().at(key), diagnostic);
        }
    }
}

type Fact = (&'static str, fn(&ErrorCode) -> Option<String>, fn(&VendorCode) -> Option<String>);

/// What is true of an error if it is true of the vendor's code for it.
const FACTS: [Fact; 2] = [
    ("severity", |error| error.severity.clone(), |code| code.severity.clone()),
    (
        "resettable",
        |error| error.resettable.map(|resettable| resettable.to_string()),
        |code| code.resettable.map(|resettable| resettable.to_string()),
    ),
];
