use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::lint::overlap::overlapping;
use crate::model::{Device, Section};

rule! {
    /// A value of a parameter means one thing. Where two ranges of values share one, whoever sees it cannot tell what it
    /// means.
    ///
    /// ## Fires
    /// ```toml
    /// [parameters.ramp]
    /// name = "Ramp"
    /// values = { "0..=3" = "slow", "2..=5" = "fast" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [parameters.ramp]
    /// name = "Ramp"
    /// values = { "0..=3" = "slow", "4..=5" = "fast" }
    /// ```
    pub(super) static RULE = "overlapping-values", Values, Warning, "a value of a parameter has two meanings";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for parameter in &device.parameters {
        for (other, range) in overlapping(&parameter.values, |range| (range.first, range.last)) {
            let message = format!("{} means `{}` and `{}`", range.first, other.name, range.name);
            let at = parameter.origin.value("values");
            let diagnostic = Diagnostic::new(&RULE, message, at, "both are here")
                .help("end the one range where the other begins");
            report.push(Section::Parameters.at(&parameter.id).at("values"), diagnostic);
        }
    }
}
