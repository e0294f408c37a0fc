//! As messages, for all that shows the messages of a check.

use super::{Places, named, range, values};
use crate::diagnostic::{Diagnostic, Diagnostics, Level, Rule};
use crate::diff::change::{Change, Class};
use crate::diff::changes::Comparison;
use crate::diff::kinds;
use crate::source::Sources;

/// The rules that the messages of a comparison are about.
pub fn rules() -> Vec<&'static Rule> {
    kinds::ALL.into_iter().flatten().map(|kind| &kind.rule).collect()
}

/// A comparison as messages about the new version. `deny` is the least class that is an error, if any is; what breaks
/// nothing is a remark.
pub fn findings(comparison: &Comparison, old: &Sources, new: &Sources, deny: Option<Class>) -> Diagnostics {
    let places = Places { old, new };
    let mut found = Diagnostics::default();
    for change in &comparison.changes {
        found.push(finding(comparison, change, &places, deny));
    }
    found.finish();
    found
}

fn finding(comparison: &Comparison, change: &Change, places: &Places<'_>, deny: Option<Class>) -> Diagnostic {
    let class = change.kind.class;
    let name = named(change).map_or(String::new(), |name| format!(" {name}"));
    let values = values(change, "→");
    let values = if values.is_empty() { values } else { format!(": {values}") };
    let range = range(comparison, change, ", ");
    let message = format!("{}{name}: {}{range}{values}", change.at, change.kind.rule.summary);
    let message = message.trim_start_matches(": ").to_owned();
    let mut finding = Diagnostic::bare(&change.kind.rule, message);
    finding.level = if deny.is_some_and(|deny| class >= deny) { Level::Error } else { class.level() };
    if let Some(at) = change.new_at {
        finding = finding.label(at, "");
    }
    let (was, _) = places.of(change);
    let finding = was.into_iter().fold(finding, |finding, was| finding.note(format!("it was at {was}")));
    finding.note(format!("{}: {}", class.name(), class.about()))
}
