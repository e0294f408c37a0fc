//! What the rules found.

use crate::diagnostic::Diagnostic;

/// A fault at something that has a name, so that an erratum can answer it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Finding {
    /// What the fault is at: `0x170A`, `0x5010:00`, `states.fault`, `identity.revision` ...
    pub(crate) at: String,
    pub(crate) diagnostic: Diagnostic,
}

/// Collects what the rules find.
#[derive(Debug, Default)]
pub(crate) struct Report {
    findings: Vec<Finding>,
}

impl Report {
    /// Reports a fault at something.
    pub(crate) fn push(&mut self, at: impl ToString, diagnostic: Diagnostic) {
        self.findings.push(Finding { at: at.to_string(), diagnostic });
    }

    /// The findings, each place once: what is written once for all axes has its fault once, at the first
    /// of them.
    pub(super) fn finish(mut self) -> Vec<Finding> {
        let key = |finding: &Finding| (finding.diagnostic.rule.name, finding.diagnostic.at());
        self.findings.sort_by(|a, b| (key(a), &a.at).cmp(&(key(b), &b.at)));
        self.findings.dedup_by(|later, first| key(later) == key(first) && later.at != first.at);
        self.findings
    }
}
