//! Messages as data: what is wrong, where, why, and what to do about it.
//!
//! Nothing here prints. A stage makes [`Diagnostic`]s and collects them in [`Diagnostics`]; a renderer
//! turns them into text.

pub mod faults;
mod list;
pub mod render;
mod rule;

pub use list::{Diagnostics, KEPT};
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
    /// How many findings it stands for: itself, or all that were cut in its place.
    pub count: usize,
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

/// How many bytes of a text are worth reading: a message names what it is about, and that can be long.
const LONGEST: usize = 2_000;

/// The beginning of a text, or all of it if it is not too long.
fn shortened(text: impl Into<String>) -> String {
    let mut text = text.into();
    if text.len() > LONGEST {
        let end = text.char_indices().map(|(at, _)| at).take_while(|at| *at <= LONGEST).last();
        text.truncate(end.unwrap_or_default());
        text.push('…');
        text.shrink_to_fit();
    }
    text
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
        Self { rule, level: rule.level, message: shortened(message), labels, notes, helps, count: 1 }
    }

    /// Points at another place.
    #[must_use]
    pub fn label(mut self, at: Location, text: impl Into<String>) -> Self {
        self.labels.push(Label { at, text: shortened(text) });
        self
    }

    /// Says why.
    #[must_use]
    pub fn note(mut self, text: impl Into<String>) -> Self {
        self.notes.push(shortened(text));
        self
    }

    /// Says what to do.
    #[must_use]
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.helps.push(Help { text: shortened(text), edits: Vec::new(), sure: false });
        self
    }

    /// Says what could be done, with the edit that does it; whether it is right, a person has to say.
    #[must_use]
    pub fn suggest(mut self, text: impl Into<String>, at: Location, replacement: impl Into<String>) -> Self {
        let edits = vec![Edit { at, text: replacement.into() }];
        self.helps.push(Help { text: shortened(text), edits, sure: false });
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
