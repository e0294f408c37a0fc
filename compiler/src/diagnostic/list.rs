//! The messages of a run, and how many of them there can be.

use std::collections::BTreeMap;

use super::{Diagnostic, Level, Rule};

/// How many messages of a rule are kept. Whoever has more has one fault that shows everywhere, or a rule to switch off;
/// and a description cannot make devc keep more than a multiple of its own size.
pub const KEPT: usize = 10_000;

/// How many messages of a rule may say what was probably meant, which takes a search through all that is there.
const EXPLAINED: usize = 100;

/// The messages of a run.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Diagnostics {
    list: Vec<Diagnostic>,
    /// How many messages of each rule are in the list.
    counts: BTreeMap<&'static str, usize>,
}

impl Diagnostics {
    /// Keeps a message, as long as there are not too many of its rule.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        let count = self.counts.entry(diagnostic.rule.name).or_default();
        *count += 1;
        // twice as many, so that the cost of cutting is spread over those that are cut
        let is_full = *count > 2 * KEPT;
        self.list.push(diagnostic);
        if is_full {
            self.finish();
        }
    }

    /// Whether a message of a rule may still say what was probably meant.
    pub(crate) fn has_room(&self, rule: &Rule) -> bool {
        self.counts.get(rule.name).is_none_or(|count| *count < EXPLAINED)
    }

    /// Whether something forbids the next stage.
    pub fn has_errors(&self) -> bool {
        self.list.iter().any(|diagnostic| diagnostic.level == Level::Error)
    }

    /// How many findings of a level there are.
    pub fn count(&self, level: Level) -> usize {
        let of_level = self.list.iter().filter(|diagnostic| diagnostic.level == level);
        of_level.map(|diagnostic| diagnostic.count).sum()
    }

    /// The messages in the order in which they were found.
    pub fn iter(&self) -> impl Iterator<Item = &Diagnostic> {
        self.list.iter()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Sorts by place, then by rule, and drops what is said twice, so that the order in which rules ran does not show;
    /// then cuts what is beyond [`KEPT`].
    pub fn finish(&mut self) {
        self.list.sort_by(|a, b| (a.at(), a.rule.name, &a.message).cmp(&(b.at(), b.rule.name, &b.message)));
        self.list.dedup();
        self.cut(KEPT);
    }

    /// Leaves so many messages of each rule, the first ones, and puts one in place of the others of the rule that says
    /// how many they were. One message is worth as much as one that stands for it, so it is not cut alone.
    pub fn cut(&mut self, most: usize) {
        let mut rules: BTreeMap<&'static str, Kept> = BTreeMap::new();
        for diagnostic in std::mem::take(&mut self.list) {
            let kept = rules.entry(diagnostic.rule.name).or_default();
            // what stands for others is no message that could be left
            if diagnostic.count == 1 && kept.count < most {
                kept.count += 1;
                self.list.push(diagnostic);
                continue;
            }
            match kept.rest.and_then(|place| self.list.get_mut(place)) {
                Some(rest) => rest.take(&diagnostic),
                None => {
                    kept.rest = Some(self.list.len());
                    self.list.push(diagnostic);
                }
            }
        }
        self.counts = rules.into_iter().map(|(rule, kept)| (rule, kept.count)).collect();
    }
}

/// What is left of a rule's messages.
#[derive(Default)]
struct Kept {
    count: usize,
    /// The place of the message that stands for the rest.
    rest: Option<usize>,
}

impl Diagnostic {
    /// Stands for another one, too; its place is that of the first.
    fn take(&mut self, other: &Self) {
        self.count += other.count;
        self.level = self.level.max(other.level);
        self.message = format!("and {} more of these", self.count);
        self.labels.truncate(1);
        self.labels.iter_mut().for_each(|label| "the next one".clone_into(&mut label.text));
        self.notes.clear();
        self.helps.clear();
    }
}

impl IntoIterator for Diagnostics {
    type Item = Diagnostic;
    type IntoIter = std::vec::IntoIter<Diagnostic>;

    fn into_iter(self) -> Self::IntoIter {
        self.list.into_iter()
    }
}

impl Extend<Diagnostic> for Diagnostics {
    fn extend<T: IntoIterator<Item = Diagnostic>>(&mut self, iter: T) {
        iter.into_iter().for_each(|diagnostic| self.push(diagnostic));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::faults::{MISSING_KEY, UNKNOWN_KEY};
    use crate::source::{FileId, Location};

    fn at(place: usize) -> Location {
        let place = u32::try_from(place).expect("a place");
        Location { file: FileId(0), start: place, end: place }
    }

    fn found(rule: &'static Rule, places: impl Iterator<Item = usize>) -> impl Iterator<Item = Diagnostic> {
        places.map(move |place| Diagnostic::new(rule, "found", at(place), ""))
    }

    #[test]
    fn what_is_beyond_a_limit_is_counted() {
        let mut diagnostics = Diagnostics::default();
        diagnostics.extend(found(&UNKNOWN_KEY, (0..90).rev()));
        diagnostics.extend(found(&MISSING_KEY, 0..10));
        diagnostics.finish();
        let mut twice = diagnostics.clone();
        diagnostics.cut(10);
        assert_eq!(diagnostics.count(Level::Error), 100);
        assert_eq!(diagnostics.iter().count(), 10 + 10 + 1);
        let rest = diagnostics.iter().find(|it| it.count > 1).expect("a message for the rest");
        assert_eq!(
            (rest.rule.name, rest.message.as_str(), rest.at()),
            ("unknown-key", "and 80 more of these", Some(at(10)))
        );
        twice.cut(50);
        twice.cut(10);
        assert_eq!(twice, diagnostics, "in two steps it is the same");
    }

    #[test]
    fn one_message_is_not_cut_alone() {
        let mut diagnostics = Diagnostics::default();
        diagnostics.extend(found(&UNKNOWN_KEY, 0..11));
        diagnostics.finish();
        diagnostics.cut(10);
        assert!(diagnostics.iter().all(|it| it.message == "found"));
        assert_eq!(diagnostics.iter().count(), 11);
    }

    #[test]
    fn a_rule_has_a_limit_whatever_is_pushed() {
        let mut diagnostics = Diagnostics::default();
        let count = 5 * KEPT;
        for diagnostic in found(&UNKNOWN_KEY, (0..count).rev()) {
            diagnostics.push(diagnostic);
            assert!(diagnostics.list.len() <= 2 * KEPT + 2);
        }
        diagnostics.finish();
        assert_eq!(diagnostics.count(Level::Error), count);
        assert_eq!(diagnostics.iter().count(), KEPT + 1);
        let last = diagnostics.iter().last().expect("a message");
        assert_eq!(last.message, format!("and {} more of these", count - KEPT));
        assert_eq!(last.at(), Some(at(KEPT)), "the first ones are kept");
    }
}
