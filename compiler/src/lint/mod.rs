//! The rules: what is wrong with a device although it could be read.

mod checked;
mod errata;
mod levels;
mod lookup;
mod report;
mod rules;
mod sibling;
#[cfg(test)]
mod tests;
mod texts;

pub use checked::Checked;
pub use levels::Levels;
pub use rules::ALL;

use errata::Errata;

pub(crate) use report::Report;

use crate::diagnostic::{Diagnostics, Rule};
use crate::model::{Device, Family};
use crate::source::Sources;

/// A rule with the function that looks for its fault.
pub struct Lint {
    /// What it is about.
    pub rule: &'static Rule,
    pub(crate) check: fn(&Device, &mut Report),
}

/// Runs every rule on every member; the family comes back as checked if none of them refuses it.
///
/// Errata take out what they answer, then levels decide how bad the rest is.
pub fn check(
    family: Family,
    levels: &Levels,
    sources: &Sources,
    diagnostics: &mut Diagnostics,
) -> Option<Checked<Family>> {
    run(ALL, &family, levels, sources, diagnostics);
    (!diagnostics.has_errors()).then_some(Checked(family))
}

/// Runs rules on all members, in any order.
fn run<'l>(
    rules: impl IntoIterator<Item = &'l Lint> + Clone,
    family: &Family,
    levels: &Levels,
    sources: &Sources,
    diagnostics: &mut Diagnostics,
) {
    let mut errata = Errata::default();
    for (i, device) in family.members.iter().enumerate() {
        let earlier = family.members.get(..i).unwrap_or_default();
        let mut report = Report::new(sources, earlier);
        for lint in rules.clone() {
            (lint.check)(device, &mut report);
        }
        let mut findings = report.finish();
        errata.apply(device, &mut findings);
        diagnostics.extend(findings.into_iter().filter_map(|finding| levels.judge(finding.diagnostic)));
    }
    let beyond = errata.idle().chain(levels.unknown());
    diagnostics.extend(beyond.filter_map(|diagnostic| levels.judge(diagnostic)));
}
