//! The rules: what is wrong with a device although it could be read.

mod checked;
mod errata;
mod images;
mod levels;
mod lookup;
mod occupant;
mod overlap;
mod refusal;
mod report;
pub(crate) mod rules;
mod sibling;
mod slips;
#[cfg(test)]
mod tests;
mod texts;
mod words;

pub use checked::Checked;
pub use levels::Levels;
pub use rules::ALL;

use errata::Errata;
use report::Finding;

pub(crate) use report::Report;

use crate::diagnostic::{Diagnostics, Group, Rule};
use crate::model::{Device, Family};
use crate::resolve::Resolved;
use crate::source::Sources;

/// A rule with the function that looks for its fault.
pub struct Lint {
    /// What it is about.
    pub rule: &'static Rule,
    pub(crate) check: fn(&Device, &mut Report),
}

/// Runs every rule on every member; the family comes back as checked, as it holds, if none of them refuses it.
///
/// Rules judge what is written. Errata take out what they answer, then levels decide how bad the rest is. What holds
/// instead is judged, too: it must not have the fault that it answers, nor another. Of the rules about outputs, only those
/// of `outputs` are asked.
pub(crate) fn check(
    resolved: Resolved,
    levels: &Levels,
    outputs: &[&Rule],
    sources: &Sources,
    diagnostics: &mut Diagnostics,
) -> Option<Checked<Family>> {
    let is_asked = |lint: &&Lint| {
        let named = || outputs.iter().any(|rule| rule.name == lint.rule.name);
        lint.rule.group != Group::Output || named()
    };
    run(ALL.iter().filter(is_asked), &resolved, levels, sources, diagnostics);
    let Resolved { printed, held } = resolved;
    (!diagnostics.has_errors()).then(|| Checked(held.unwrap_or(printed)))
}

/// Runs rules on all members, in any order.
fn run<'l>(
    rules: impl IntoIterator<Item = &'l Lint> + Clone,
    resolved: &Resolved,
    levels: &Levels,
    sources: &Sources,
    diagnostics: &mut Diagnostics,
) {
    let mut errata = Errata::asking(rules.clone().into_iter().map(|lint| lint.rule.name));
    let mut messages = Vec::new();
    let (mut of_printed, mut of_held) = (Report::new(sources), Report::new(sources));
    for (i, device) in resolved.printed.members.iter().enumerate() {
        let mut printed = findings(rules.clone(), device, &mut of_printed);
        let held = resolved.held.as_ref().and_then(|held| held.members.get(i));
        let held = held.map(|device| findings(rules.clone(), device, &mut of_held));
        messages.extend(held.into_iter().flat_map(|held| errata::judge(device, &printed, held)));
        errata.apply(device, &mut printed);
        messages.extend(printed.into_iter().map(|finding| finding.diagnostic));
    }
    messages.extend(errata.idle().chain(levels.unknown()));
    messages.extend(rules::idle_remark::judge(&resolved.printed.members));
    diagnostics.extend(messages.into_iter().filter_map(|message| levels.judge(message)));
}

/// What rules find at a member of a family, behind those that were reported before.
fn findings<'l>(
    rules: impl IntoIterator<Item = &'l Lint>,
    device: &Device,
    report: &mut Report,
) -> Vec<Finding> {
    rules.into_iter().for_each(|lint| (lint.check)(device, report));
    report.finish(device)
}
