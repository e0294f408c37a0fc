//! Messages as data: what is wrong, where, why, and what to do about it.
//!
//! Nothing here prints. A stage makes [`Diagnostic`]s and collects them in [`Diagnostics`]; a renderer
//! turns them into text.

pub mod faults;
pub mod render;
mod rule;

#[allow(unused_imports)]
pub(crate) use rule::rule;
pub use rule::{Group, Level, Rule};

use crate::text::Location;

/// One message.
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnostic {
    /// The rule that was broken; its name is the message's code.
    pub rule: &'static Rule,
    /// How bad it is here.
    pub level: Level,
    /// What is wrong, in lower case, with the values in it.
    pub message: String,
    /// The places; the first is where the fault is, the others say what it disagrees with.
    pub labels: Vec<Label>,
    /// Why it is wrong: the clause of the standard, the setting that made it so.
    pub notes: Vec<String>,
    /// What to do about it.
    pub helps: Vec<Help>,
}

/// A place with what there is to say about it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Label {
    /// The place.
    pub at: Location,
    /// What to say; may be empty.
    pub text: String,
}

/// A way out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Help {
    /// What to do.
    pub text: String,
    /// The edits that do it, if a machine can; none overlap.
    pub edits: Vec<Edit>,
    /// Whether the edits are what was meant beyond reasonable doubt, so that a machine may make them.
    pub sure: bool,
}

/// A replacement of text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Edit {
    /// What to replace.
    pub at: Location,
    /// With what.
    pub text: String,
}

impl Diagnostic {
    /// A message at a place, at the rule's default level.
    pub fn new(
        rule: &'static Rule,
        message: impl Into<String>,
        at: Location,
        label: impl Into<String>,
    ) -> Self {
        Self::bare(rule, message).label(at, label)
    }

    /// A message that has no place, because there is no text to point at.
    pub fn bare(rule: &'static Rule, message: impl Into<String>) -> Self {
        let (labels, notes, helps) = (Vec::new(), Vec::new(), Vec::new());
        Self { rule, level: rule.level, message: message.into(), labels, notes, helps }
    }

    /// Points at another place.
    #[must_use]
    pub fn label(mut self, at: Location, text: impl Into<String>) -> Self {
        self.labels.push(Label { at, text: text.into() });
        self
    }

    /// Says why.
    #[must_use]
    pub fn note(mut self, text: impl Into<String>) -> Self {
        self.notes.push(text.into());
        self
    }

    /// Says what to do.
    #[must_use]
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.helps.push(Help { text: text.into(), edits: Vec::new(), sure: false });
        self
    }

    /// Says what could be done, with the edit that does it; whether it is right, a person has to say.
    #[must_use]
    pub fn suggest(mut self, text: impl Into<String>, at: Location, replacement: impl Into<String>) -> Self {
        let edits = vec![Edit { at, text: replacement.into() }];
        self.helps.push(Help { text: text.into(), edits, sure: false });
        self
    }

    /// Says what to do, with the edit that does it: what was meant is plain, as with a misspelled name.
    #[must_use]
    pub fn fix(mut self, text: impl Into<String>, at: Location, replacement: impl Into<String>) -> Self {
        self = self.suggest(text, at, replacement);
        if let Some(help) = self.helps.last_mut() {
            help.sure = true;
        }
        self
    }

    /// Where the fault is.
    pub fn at(&self) -> Option<Location> {
        self.labels.first().map(|label| label.at)
    }
}

/// The messages of a run.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Diagnostics {
    list: Vec<Diagnostic>,
}

impl Diagnostics {
    /// Keeps a message.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        self.list.push(diagnostic);
    }

    /// Whether something forbids the next stage.
    pub fn has_errors(&self) -> bool {
        self.list.iter().any(|diagnostic| diagnostic.level == Level::Error)
    }

    /// How many messages of a level there are.
    pub fn count(&self, level: Level) -> usize {
        self.list.iter().filter(|diagnostic| diagnostic.level == level).count()
    }

    /// The messages in the order in which they were found.
    pub fn iter(&self) -> impl Iterator<Item = &Diagnostic> {
        self.list.iter()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Sorts by place, then by rule, and drops what is said twice, so that the order in which rules ran
    /// does not show.
    pub fn finish(&mut self) {
        self.list.sort_by(|a, b| (a.at(), a.rule.name, &a.message).cmp(&(b.at(), b.rule.name, &b.message)));
        self.list.dedup();
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
        self.list.extend(iter);
    }
}
