use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, ErrorCode};

rule! {
    /// A code that lies in a range is an error of that range: what the range says of all of its codes, it says of this one,
    /// too. If both have an error register, a severity or a way to reset it, and not the same, one of them is wrong, or
    /// the range is too wide. A range that has a name alone is a heading.
    ///
    /// ## Fires
    /// ```toml
    /// [errors]
    /// "0x7100..=0x71FF" = { name = "Power", register = 0x21, resettable = true }
    /// 0x7121            = { name = "Motor blocked", register = 0x21, resettable = false }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [errors]
    /// "0x7100..=0x7120" = { name = "Power", register = 0x21, resettable = true }
    /// 0x7121            = { name = "Motor blocked", register = 0x21, resettable = false }
    /// "0x7122..=0x71FF" = { name = "Power" }
    /// ```
    pub(super) static RULE = "code-in-range", Values, Warning,
        "an error code contradicts the range it is in";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    // the ranges that have begun and not ended, the innermost last
    let mut around: Vec<&ErrorCode> = Vec::new();
    let mut errors = BTreeMap::new();
    for error in &device.errors {
        errors.insert((error.code, u16::MAX - error.last), error);
    }
    for error in errors.into_values() {
        while around.last().is_some_and(|range| range.last < error.code) {
            around.pop();
        }
        for (key, what) in FACTS {
            let range = around.iter().rev().find(|range| what(range).is_some());
            if let Some(range) = range
                && let (Some(own), Some(of_all)) = (what(error), what(range))
                && own != of_all
            {
                report.push(error.place(), told(error, range, key, [own, of_all]));
                break;
            }
        }
        if error.is_range() {
            around.push(error);
        }
    }
}

type Fact = fn(&ErrorCode) -> Option<String>;

/// What is true of a code if it is true of its range.
const FACTS: [(&str, Fact); 3] = [
    ("register", |error| error.register.map(|register| format!("0x{register:02X}"))),
    ("severity", |error| error.severity.clone()),
    ("resettable", |error| error.resettable.map(|resettable| resettable.to_string())),
];

fn told(error: &ErrorCode, range: &ErrorCode, key: &str, [own, of_all]: [String; 2]) -> Diagnostic {
    let message = format!(
        "0x{:04X} has {key} {own}, all of 0x{:04X} to 0x{:04X} have {of_all}",
        error.code, range.code, range.last
    );
    Diagnostic::new(&RULE, message, error.origin.value(key), "not as the range has it")
        .label(range.origin.value(key), "for the whole range")
        .help("end the range before the code, or say of the range only what all of its codes have")
}
