use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::Device;

rule! {
    /// An error code that is listed twice has two meanings. Single codes inside a range are fine: they say more
    /// than the range; two ranges that cross are not.
    ///
    /// ## Fires
    /// ```toml
    /// [errors]
    /// 0x7121 = { name = "Motor blocked" }
    /// 28961 = { name = "Motor stuck" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [errors]
    /// 0xFF01 = { name = "Motor blocked" }
    /// "0xFF00..=0xFFFF" = { name = "Manufacturer-specific" }
    /// ```
    pub(super) static RULE = "repeated-error", Values, Error, "an error code is listed twice";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (i, second) in device.errors.iter().enumerate() {
        let same = |first: &&crate::model::ErrorCode| {
            let equal = (first.code, first.last) == (second.code, second.last);
            let crossing = first.code < second.code && second.code <= first.last && first.last < second.last;
            equal || crossing
        };
        let Some(first) = device.errors.iter().take(i).find(same) else { continue };
        let message = format!("0x{:04X} is `{}` and `{}`", second.code, first.name, second.name);
        let diagnostic = Diagnostic::new(&RULE, message, second.origin.header(), "again here")
            .label(first.origin.header(), "first here");
        report.push(format!("errors.0x{:04X}", second.code), diagnostic);
    }
}
