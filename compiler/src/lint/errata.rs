//! Answers to findings.

use std::collections::{BTreeMap, BTreeSet};

use super::report::Finding;
use super::rules::{ALL, idle_erratum, unknown_rule, unmended_erratum};
use crate::diagnostic::Diagnostic;
use crate::model::{Device, Erratum, Place};
use crate::source::Location;

/// The errata of a family, each known by its place, since its members share them.
#[derive(Debug, Default)]
pub(super) struct Errata {
    /// The rules that are asked.
    asked: BTreeSet<&'static str>,
    answering: BTreeSet<Location>,
    idle: BTreeMap<Location, Diagnostic>,
}

impl Errata {
    /// None yet, where these rules are asked.
    pub(super) fn asking(rules: impl IntoIterator<Item = &'static str>) -> Self {
        Self { asked: rules.into_iter().collect(), ..Self::default() }
    }

    /// Takes out the findings about a member that its errata answer.
    pub(super) fn apply(&mut self, device: &Device, findings: &mut Vec<Finding>) {
        // of two with the same answer, the first gives it
        let mut answers: BTreeMap<(&str, &Place), Location> = BTreeMap::new();
        for erratum in &device.errata {
            answers.entry((&erratum.rule, &erratum.at)).or_insert(erratum.origin.header());
        }
        let mut answering = BTreeSet::new();
        findings.retain(|finding| match answers.get(&(finding.diagnostic.rule.name, &finding.at)) {
            Some(at) => {
                answering.insert(*at);
                false
            }
            None => true,
        });
        self.note_idle(device, findings, &answering);
        self.answering.append(&mut answering);
    }

    /// Makes the messages about the errata that answer nothing about a member.
    fn note_idle(&mut self, device: &Device, findings: &[Finding], answering: &BTreeSet<Location>) {
        let is_idle = |erratum: &&Erratum| !answering.contains(&erratum.origin.header());
        // a rule that nobody asked may have found what the erratum answers
        let is_asked = |erratum: &&Erratum| {
            self.asked.contains(&*erratum.rule) || !ALL.iter().any(|lint| lint.rule.name == erratum.rule)
        };
        let mut idle = device.errata.iter().filter(is_asked).filter(is_idle).peekable();
        if idle.peek().is_none() {
            return;
        }
        let mut left: BTreeMap<&str, Vec<&Place>> = BTreeMap::new();
        for finding in findings {
            left.entry(finding.diagnostic.rule.name).or_default().push(&finding.at);
        }
        for erratum in idle {
            let unknown = unknown_rule::judge(&erratum.rule, erratum.origin.value("rule"));
            let places = left.get(&*erratum.rule).map_or(&[][..], Vec::as_slice);
            let message = unknown.unwrap_or_else(|| idle_erratum::judge(erratum, places));
            self.idle.insert(erratum.origin.header(), message);
        }
    }

    /// A message for each erratum that answers nothing about any member.
    pub(super) fn idle(self) -> impl Iterator<Item = Diagnostic> {
        let Self { answering, idle, .. } = self;
        idle.into_iter().filter(move |(at, _)| !answering.contains(at)).map(|(_, diagnostic)| diagnostic)
    }
}

/// What is to be said of a member as it holds: faults that it did not have as written, and those that an erratum
/// answers by something else but leaves as they are.
pub(super) fn judge(device: &Device, printed: &[Finding], held: Vec<Finding>) -> Vec<Diagnostic> {
    fn key(finding: &Finding) -> (&str, &Place) {
        (finding.diagnostic.rule.name, &finding.at)
    }
    let known: BTreeSet<_> = printed.iter().map(key).collect();
    let (still, new): (Vec<_>, Vec<_>) = held.into_iter().partition(|finding| known.contains(&key(finding)));
    let answered = device.errata.iter().filter(|erratum| erratum.holds.is_some());
    let still: BTreeSet<_> = still.iter().map(key).collect();
    let unmended = answered.filter(|erratum| still.contains(&(&*erratum.rule, &erratum.at)));
    let unmended = unmended.map(unmended_erratum::judge).collect::<Vec<_>>();
    new.into_iter().map(|finding| finding.diagnostic).chain(unmended).collect()
}
