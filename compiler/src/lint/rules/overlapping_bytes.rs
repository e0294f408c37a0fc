use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::lint::overlap::overlapping;
use crate::model::{Device, Section};

rule! {
    /// A byte of a message is one thing. If two fields of a telegram share a byte, whoever takes it apart gets one of them
    /// wrong.
    ///
    /// ## Fires
    /// ```toml
    /// [telegrams.request]
    /// name = "Request"
    /// bytes = { "0..=1" = "length", "1..=3" = "address" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [telegrams.request]
    /// name = "Request"
    /// bytes = { "0..=1" = "length", "2..=3" = "address" }
    /// ```
    pub(super) static RULE = "overlapping-bytes", Values, Error, "a byte of a telegram has two meanings";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for telegram in &device.telegrams {
        for (other, field) in overlapping(&telegram.fields, |field| (field.low, field.high)) {
            let message = format!("byte {} is `{}` and `{}`", field.low, other.name, field.name);
            let at = telegram.origin.value(&field.path("bytes"));
            let diagnostic = Diagnostic::new(&RULE, message, at, "again here")
                .label(telegram.origin.value(&other.path("bytes")), "first here");
            report.push(Section::Telegrams.at(&telegram.id).at(format!("bytes.{}", field.low)), diagnostic);
        }
    }
}
