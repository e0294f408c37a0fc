use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
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
        let mut ranges: Vec<_> = parameter.values.iter().collect();
        ranges.sort_by_key(|range| (range.first, range.last));
        let mut widest = ranges.first().copied();
        for range in ranges.into_iter().skip(1) {
            if let Some(other) = widest.filter(|other| range.first <= other.last) {
                let message = format!("{} means `{}` and `{}`", range.first, other.name, range.name);
                let at = parameter.origin.value("values");
                let diagnostic = Diagnostic::new(&RULE, message, at, "both are here")
                    .help("end the one range where the other begins");
                report.push(Section::Parameters.at(&parameter.id).at("values"), diagnostic);
            }
            if widest.is_none_or(|other| other.last < range.last) {
                widest = Some(range);
            }
        }
    }
}
