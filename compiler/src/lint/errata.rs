//! Answers to findings.

use std::collections::{BTreeMap, BTreeSet};

use super::report::Finding;
use super::rules::{idle_erratum, unknown_rule, unmended_erratum};
use crate::diagnostic::Diagnostic;
use crate::model::Device;
use crate::source::Location;

/// The errata of a family, each known by its place, since its members share them.
#[derive(Debug, Default)]
pub(super) struct Errata {
    answering: BTreeSet<Location>,
    idle: BTreeMap<Location, Diagnostic>,
}

impl Errata {
    /// Takes out the findings about a member that its errata answer.
    pub(super) fn apply(&mut self, device: &Device, findings: &mut Vec<Finding>) {
        for erratum in &device.errata {
            let before = findings.len();
            findings
                .retain(|finding| finding.diagnostic.rule.name != erratum.rule || finding.at != erratum.at);
            let at = erratum.origin.header();
            if findings.len() < before {
                self.answering.insert(at);
            } else {
                let unknown = unknown_rule::judge(&erratum.rule, erratum.origin.value("rule"));
                self.idle.insert(at, unknown.unwrap_or_else(|| idle_erratum::judge(erratum, findings)));
            }
        }
    }

    /// A message for each erratum that answers nothing about any member.
    pub(super) fn idle(self) -> impl Iterator<Item = Diagnostic> {
        let Self { answering, idle } = self;
        idle.into_iter().filter(move |(at, _)| !answering.contains(at)).map(|(_, diagnostic)| diagnostic)
    }
}

/// What is to be said of a member as it holds: faults that it did not have as written, and those that an erratum
/// answers by something else but leaves as they are.
pub(super) fn judge(device: &Device, printed: &[Finding], held: Vec<Finding>) -> Vec<Diagnostic> {
    let key = |finding: &Finding| (finding.diagnostic.rule.name, finding.at.clone());
    let known: BTreeSet<_> = printed.iter().map(key).collect();
    let (still, new): (Vec<_>, Vec<_>) = held.into_iter().partition(|finding| known.contains(&key(finding)));
    let answered = device.errata.iter().filter(|erratum| erratum.holds.is_some());
    let unmended = answered.filter(|erratum| {
        still.iter().any(|finding| finding.diagnostic.rule.name == erratum.rule && finding.at == erratum.at)
    });
    let unmended = unmended.map(unmended_erratum::judge).collect::<Vec<_>>();
    new.into_iter().map(|finding| finding.diagnostic).chain(unmended).collect()
}
