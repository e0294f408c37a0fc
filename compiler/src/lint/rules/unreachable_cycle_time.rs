use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// A limit takes a cycle time that is one of its choices and not below its least. A choice below that can never be taken.
    ///
    /// ## Fires
    /// ```toml
    /// [cycle-times.all]
    /// name = "All modes"
    /// min = "1 ms"
    /// choices = ["500 us", "1 ms", "2 ms"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [cycle-times.all]
    /// name = "All modes"
    /// min = "500 us"
    /// choices = ["500 us", "1 ms", "2 ms"]
    /// ```
    pub(super) static RULE = "unreachable-cycle-time", ProcessData, Warning,
        "a cycle time that can be chosen is shorter than the shortest";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for limit in &device.cycle_times {
        let Some(least) = limit.min else { continue };
        for (i, choice) in limit.choices.iter().enumerate().filter(|(_, choice)| choice.0 < least.0) {
            let message = format!("`{}` lets {choice} be chosen, but takes {least} at least", limit.name);
            let at = limit.origin.value(&format!("choices.{i}"));
            let diagnostic = Diagnostic::new(&RULE, message, at, "never taken");
            let diagnostic = diagnostic.label(limit.origin.value("min"), "the shortest");
            report.push(Section::CycleTimes.at(&limit.id), diagnostic);
        }
    }
}
