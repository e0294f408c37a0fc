//! Answers to findings.

use super::report::Finding;
use super::rules::{idle_erratum, unknown_rule};
use crate::model::Device;

/// Takes out the findings that an erratum answers, and reports errata that answer none.
pub(super) fn apply(device: &Device, findings: &mut Vec<Finding>) {
    let mut idle = Vec::new();
    for erratum in &device.errata {
        let before = findings.len();
        findings.retain(|finding| finding.diagnostic.rule.name != erratum.rule || finding.at != erratum.at);
        if findings.len() == before {
            let place = erratum.origin.value("rule");
            let unknown = unknown_rule::judge(&erratum.rule, place);
            idle.push(unknown.unwrap_or_else(|| idle_erratum::judge(erratum, findings)));
        }
    }
    let at = |number: usize| format!("errata.{number}");
    findings.extend(idle.into_iter().enumerate().map(|(i, diagnostic)| Finding { at: at(i), diagnostic }));
}
