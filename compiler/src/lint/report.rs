//! What the rules found.

use super::sibling::Sibling;
use crate::diagnostic::Diagnostic;
use crate::model::{Device, Entry, Object};
use crate::source::{FileId, Node, Origin, Sources};

/// A fault at something that has a name, so that an erratum can answer it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Finding {
    /// What the fault is at, by the shortest name that is its own:
    ///
    /// - `0x6502`, an object with a single value, or an object as a whole; `0x5010:00`, an entry;
    /// - `0x1601`, a PDO; `0x1601:04`, what is mapped fourth, as in its mapping object;
    /// - `states.fault`, `commands.quick-stop`, `transitions.16`, `modes.8`, `errors.0x3130`,
    ///   `vendor-codes.657`, `units.position`, `words.statusword.9`, `sync-managers.outputs`: a table, then
    ///   the key in it, as a description has them;
    /// - `identity.revision`, `device.profile`: a key of a section that is there once.
    ///
    /// What is written once for all axes is named on the first axis that has the fault.
    pub(crate) at: String,
    pub(crate) diagnostic: Diagnostic,
}

/// Collects what the rules find.
#[derive(Debug, Default)]
pub(crate) struct Report {
    findings: Vec<Finding>,
    /// The files that are profiles.
    profiles: Vec<FileId>,
    /// The members of the family before the device.
    earlier: Vec<Sibling>,
}

impl Report {
    /// An empty report on a device that was read from these files and comes after these in its family.
    pub(super) fn new(sources: &Sources, earlier: &[Device]) -> Self {
        let profiles = sources.iter().filter(|(_, file)| file.embedded).map(|(id, _)| id).collect();
        let earlier = earlier.iter().map(Sibling::new).collect();
        Self { findings: Vec::new(), profiles, earlier }
    }

    /// Reports a fault at something.
    pub(crate) fn push(&mut self, at: impl ToString, diagnostic: Diagnostic) {
        self.findings.push(Finding { at: at.to_string(), diagnostic });
    }

    /// The members of the family before the device.
    pub(crate) fn earlier(&self) -> &[Sibling] {
        &self.earlier
    }

    /// What a profile says at `path`, whether or not the description says otherwise.
    pub(crate) fn profile<'o>(&self, origin: &'o Origin, path: &str) -> Option<&'o Node> {
        let known = |node: &&Node| self.profiles.contains(&node.at.file);
        origin.under(path).filter(known).or_else(|| origin.node(path).filter(known))
    }

    /// What a profile says of a key of an entry, in the entry's table or for all entries in the object's.
    pub(crate) fn profile_of<'o>(&self, object: &'o Object, entry: &'o Entry, key: &str) -> Option<&'o Node> {
        let own = self.profile(&entry.origin, key);
        let is_count = entry.address.subindex == 0 && object.entries.len() > 1;
        match is_count {
            // One that is not described lies where the object does, but shares nothing with its entries.
            true => own.filter(|_| entry.origin.header() != object.origin.header()),
            false => own.or_else(|| self.profile(&object.origin, key)),
        }
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
