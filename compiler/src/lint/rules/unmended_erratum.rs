use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Erratum};

rule! {
    /// What an erratum says to hold takes the place of what is printed. If the rule then finds the same fault again, it
    /// does not hold either, or the erratum corrects something else.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gains"
    ///
    /// [objects.0x2000.entries]
    /// 0 = { default = 3 }
    /// 1 = { name = "Proportional", type = "UINT16" }
    /// 2 = { name = "Integral", type = "UINT16" }
    ///
    /// [[errata]]
    /// rule = "contradicted-count"
    /// at = "0x2000:00"
    /// says = { default = 3 }
    /// holds = { default = 4 }
    /// why = "two rows follow"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gains"
    ///
    /// [objects.0x2000.entries]
    /// 0 = { default = 3 }
    /// 1 = { name = "Proportional", type = "UINT16" }
    /// 2 = { name = "Integral", type = "UINT16" }
    ///
    /// [[errata]]
    /// rule = "contradicted-count"
    /// at = "0x2000:00"
    /// says = { default = 3 }
    /// holds = { default = 2 }
    /// why = "two rows follow"
    /// ```
    pub(super) static RULE = "unmended-erratum", Facts, Error, "what an erratum says to hold has the same fault";
}

/// Nothing by itself: it shows when the rules have judged what holds.
pub(super) fn check(_: &Device, _: &mut Report) {}

/// The message about an erratum whose fault is found again.
pub(in crate::lint) fn judge(erratum: &Erratum) -> Diagnostic {
    let message = format!("`{}` finds the same at {} in what holds", erratum.rule, erratum.at);
    Diagnostic::new(&RULE, message, erratum.origin.value("holds"), "not without the fault")
        .help("correct what holds, or leave it out if nobody knows")
}
