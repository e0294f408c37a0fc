use std::collections::BTreeMap;

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
    let mut begun: BTreeMap<u16, &ErrorCode> = BTreeMap::new();
    let ranges: Vec<&ErrorCode> = device.errors.iter().filter(|error| error.is_range()).collect();
    // In the order of their codes: each can only cross those that begin before it and end in it.
    for same in ranges.chunk_by(|a, b| a.code == b.code) {
        for second in same {
            if let Some((_, first)) = begun.range(second.code..second.last).next() {
                report.push(second.place(), repeated(first, second));
            }
        }
        same.iter().for_each(|range| {
            begun.entry(range.last).or_insert(range);
        });
    }
}

fn repeated(first: &ErrorCode, second: &ErrorCode) -> Diagnostic {
    let message = format!("0x{:04X} is `{}` and `{}`", second.code, first.name, second.name);
    Diagnostic::new(&RULE, message, second.origin.header(), "again here")
        .label(first.origin.header(), "first here")
}
