//! Answers to findings.

use std::collections::{BTreeMap, BTreeSet};

use super::report::Finding;
use super::rules::{idle_erratum, unknown_rule};
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
