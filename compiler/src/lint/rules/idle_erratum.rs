use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Erratum, Place};

rule! {
    /// An erratum answers one finding of one rule. If the rule finds nothing there, the manual or the
    /// description has changed, or the erratum names the wrong place; either way it says something that no
    /// longer holds.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gains"
    ///
    /// [objects.0x2000.entries]
    /// 0 = { default = 2 }
    /// 1 = { name = "Proportional", type = "UINT16" }
    /// 2 = { name = "Integral", type = "UINT16" }
    ///
    /// [[errata]]
    /// rule = "contradicted-count"
    /// at = "0x2000:00"
    /// says = { default = 2 }
    /// why = "nobody knows how many rows follow"
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
    pub(super) static RULE = "idle-erratum", Facts, Error, "an erratum answers nothing";
}

/// Nothing by itself: which errata are idle shows only after all other rules have run.
pub(super) fn check(_: &Device, _: &mut Report) {}

/// The message about an erratum that answers none of the findings of its rule, which are at other places.
pub(in crate::lint) fn judge(erratum: &Erratum, others: &[&Place]) -> Diagnostic {
    let Erratum { rule, at, .. } = erratum;
    let message = format!("`{rule}` finds nothing at {at}");
    let diagnostic = Diagnostic::new(&RULE, message, erratum.origin.value("at"), "nothing to answer here");
    if others.is_empty() {
        diagnostic.help("take the erratum out if the fault is gone")
    } else {
        let more = if others.len() > NAMED { " and elsewhere" } else { "" };
        let others = others.iter().take(NAMED).map(ToString::to_string).collect::<Vec<_>>().join(", ");
        diagnostic.help(format!("it finds something at {others}{more}"))
    }
}

/// How many places a message names.
const NAMED: usize = 20;
