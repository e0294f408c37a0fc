use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, ErrorCode};

rule! {
    /// A code in two ranges that cross has two meanings. Single codes and ranges inside a range are fine: they say more
    /// than the range.
    ///
    /// ## Fires
    /// ```toml
    /// [errors]
    /// "0x7100..=0x71FF" = { name = "Power" }
    /// "0x7180..=0x72FF" = { name = "Measurement" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [errors]
    /// 0xFF01 = { name = "Motor blocked" }
    /// "0xFF00..=0xFFFF" = { name = "Manufacturer-specific" }
    /// ```
    pub(super) static RULE = "repeated-error", Values, Error, "ranges of error codes cross";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut ranges: Vec<&ErrorCode> = Vec::new();
    for second in device.errors.iter().filter(|error| error.is_range()) {
        let crosses = |first: &&&ErrorCode| {
            first.code < second.code && second.code <= first.last && first.last < second.last
        };
        if let Some(first) = ranges.iter().find(crosses) {
            report.push(second.place(), repeated(first, second));
        }
        ranges.push(second);
    }
}

fn repeated(first: &ErrorCode, second: &ErrorCode) -> Diagnostic {
    let message = format!("0x{:04X} is `{}` and `{}`", second.code, first.name, second.name);
    Diagnostic::new(&RULE, message, second.origin.header(), "again here")
        .label(first.origin.header(), "first here")
}
