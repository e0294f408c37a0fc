use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// An assumption is as good as its reason, and so is the answer to a finding: without one, nobody can judge
    /// later whether it still holds.
    ///
    /// ## Fires
    /// ```toml
    /// [device]
    /// name = "Example"
    /// vendor = "Example"
    /// physics = "YY"
    /// assumed = { physics = "" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [device]
    /// name = "Example"
    /// vendor = "Example"
    /// physics = "YY"
    /// assumed = { physics = "the sockets on the drawing are RJ45" }
    /// ```
    pub(super) static RULE = "empty-reason", Facts, Warning, "an assumption or an erratum gives no reason";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for assumption in device.assumptions.iter().filter(|it| it.reason.trim().is_empty()) {
        let message = format!("{} is assumed, but no reason is given", assumption.at);
        let diagnostic = Diagnostic::new(&RULE, message, assumption.reason_at(), "no reason");
        report.push(assumption.at.clone(), diagnostic.help("say what makes it likely"));
    }
    for (i, erratum) in device.errata.iter().enumerate() {
        if erratum.why.trim().is_empty() {
            let message =
                format!("the erratum at {} answers `{}`, but gives no reason", erratum.at, erratum.rule);
            let diagnostic = Diagnostic::new(&RULE, message, erratum.origin.value("why"), "no reason");
            report.push(Section::Errata.at(i), diagnostic.help("say how you know what holds"));
        }
    }
}
