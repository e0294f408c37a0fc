use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::Device;

rule! {
    /// Where vendor codes of errors have tables of their own, one that has none was mistyped, or was forgotten: whoever looks
    /// it up finds nothing.
    ///
    /// ## Fires
    /// ```toml
    /// [errors]
    /// 0x2310 = { name = "Overcurrent", vendor-codes = [101, 120] }
    ///
    /// [vendor-codes]
    /// 101 = { name = "Overcurrent of the power stage" }
    /// 102 = { name = "Overcurrent of the motor" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [errors]
    /// 0x2310 = { name = "Overcurrent", vendor-codes = [101, 102] }
    ///
    /// [vendor-codes]
    /// 101 = { name = "Overcurrent of the power stage" }
    /// 102 = { name = "Overcurrent of the motor" }
    /// ```
    pub(super) static RULE = "unlisted-vendor-code", Values, Warning, "an error names a vendor code that is not described";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let listed: BTreeSet<u32> = device.vendor_codes.iter().map(|code| code.code).collect();
    let are_listed =
        device.errors.iter().flat_map(|error| &error.vendor_codes).any(|code| listed.contains(code));
    for error in device.errors.iter().filter(|_| are_listed) {
        for (i, code) in error.vendor_codes.iter().enumerate().filter(|(_, code)| !listed.contains(code)) {
            let message = format!("`{}` names vendor code {code}, which is not described", error.name);
            let at = error.origin.value(&format!("vendor-codes.{i}"));
            let diagnostic = Diagnostic::new(&RULE, message, at, "not in `[vendor-codes]`")
                .help(format!("add `[vendor-codes.{code}]`, or name the code that was meant"));
            report.push(error.place().at("vendor-codes"), diagnostic.note("others have a table there"));
        }
    }
}
