//! What the rules found.

use std::rc::Rc;

use super::sibling::Sibling;
use super::slips::{self, Slip};
use crate::diagnostic::Diagnostic;
use crate::model::{Device, Place};
use crate::source::{FileId, Node, Origin, Sources};

/// A fault at something that has a name, so that an erratum can answer it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Finding {
    /// What the fault is at. What is written once for all axes is named on the first axis that has the fault.
    pub(crate) at: Place,
    pub(crate) diagnostic: Diagnostic,
}

/// Collects what the rules find.
#[derive(Debug, Default)]
pub(crate) struct Report {
    findings: Vec<Finding>,
    /// The files that are profiles.
    profiles: Vec<FileId>,
    /// The members of the family before the one that is looked at.
    earlier: Vec<Sibling>,
    /// The slips in the device, once a rule has asked for them.
    slips: Option<Rc<[Slip]>>,
}

impl Report {
    /// An empty report on the first device of those that were read from these files.
    pub(super) fn new(sources: &Sources) -> Self {
        let profiles = sources.iter().filter(|(_, file)| file.embedded).map(|(id, _)| id).collect();
        Self { profiles, ..Self::default() }
    }

    /// Reports a fault at something.
    pub(crate) fn push(&mut self, at: impl Into<Place>, diagnostic: Diagnostic) {
        self.findings.push(Finding { at: at.into(), diagnostic });
    }

    /// The members of the family before the device.
    pub(crate) fn earlier(&self) -> &[Sibling] {
        &self.earlier
    }

    /// The slips in the device that is looked at: the walk to them is long, and several rules ask.
    pub(super) fn slips(&mut self, device: &Device) -> Rc<[Slip]> {
        Rc::clone(self.slips.get_or_insert_with(|| slips::of(device).into()))
    }

    /// What a profile says at `path`, whether or not the description says otherwise.
    pub(crate) fn profile<'o>(&self, origin: &'o Origin, path: &str) -> Option<&'o Node> {
        let known = |node: &&Node| self.profiles.contains(&node.at.file);
        origin.under(path).filter(known).or_else(|| origin.node(path).filter(known))
    }

    /// The findings about a device, each place once: what is written once for all axes has its fault once, at the
    /// first of them. What comes is about the next device.
    pub(super) fn finish(&mut self, device: &Device) -> Vec<Finding> {
        self.earlier.push(Sibling::new(device));
        self.slips = None;
        let key = |finding: &Finding| (finding.diagnostic.rule.name, finding.diagnostic.at());
        self.findings.sort_by(|a, b| (key(a), &a.at).cmp(&(key(b), &b.at)));
        self.findings.dedup_by(|later, first| key(later) == key(first) && later.at != first.at);
        std::mem::take(&mut self.findings)
    }
}
