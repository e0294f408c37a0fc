use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, ErrorCode};

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
    let mut known = BTreeMap::new();
    let mut ranges: Vec<(usize, &ErrorCode)> = Vec::new();
    for (place, second) in device.errors.iter().enumerate() {
        let crosses = |(_, first): &&(usize, &ErrorCode)| {
            first.code < second.code && second.code <= first.last && first.last < second.last
        };
        let equal = known.get(&(second.code, second.last)).copied();
        let crossing = ranges.iter().find(crosses).copied();
        if let Some((_, first)) = equal.into_iter().chain(crossing).min_by_key(|(place, _)| *place) {
            report.push(format!("errors.0x{:04X}", second.code), repeated(first, second));
        }
        known.entry((second.code, second.last)).or_insert((place, second));
        ranges.extend(second.is_range().then_some((place, second)));
    }
}

fn repeated(first: &ErrorCode, second: &ErrorCode) -> Diagnostic {
    let message = format!("0x{:04X} is `{}` and `{}`", second.code, first.name, second.name);
    Diagnostic::new(&RULE, message, second.origin.header(), "again here")
        .label(first.origin.header(), "first here")
}
