//! What a message can be about.

/// A kind of fault, with all there is to say about it in general.
///
/// Made with `rule!`, which takes the documentation from the doc comment, so that the text a person
/// reads in the code, in `devc explain` and in `rules.md` is one text.
#[derive(Debug, PartialEq, Eq)]
pub struct Rule {
    /// The fault in kebab case, so that "allow *name*" reads as a sentence.
    pub name: &'static str,
    /// The family it belongs to.
    pub group: Group,
    /// How bad it is if nobody says otherwise.
    pub level: Level,
    /// Whether the level is what it is: true for faults that leave nothing to go on with.
    pub fixed: bool,
    /// One line.
    pub summary: &'static str,
    /// Markdown: why it matters, then `## Fires` and `## Silent`, each with one example.
    pub docs: &'static str,
}

/// How bad a message is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// Not reported.
    Allow,
    /// Reported; the outputs are made.
    Warning,
    /// Reported; no output is made.
    Error,
}

/// A family of rules whose level can be set together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Group {
    /// What is not TOML, or not this format.
    Format,
    /// The object dictionary.
    Dictionary,
    /// PDOs, their assignment, sync managers.
    ProcessData,
    /// States, commands, transitions, words, modes.
    StateMachine,
    /// Error codes, units, parameters.
    Values,
    /// What an output cannot express.
    Output,
    /// Sources, assumptions, errata.
    Facts,
    /// What differs from one version to the next: no rules of a check, so that no setting knows them.
    Changes,
}

impl Group {
    /// All groups of rules that a check has, in the order in which they are listed.
    pub const ALL: [Self; 7] = [
        Self::Format,
        Self::Dictionary,
        Self::ProcessData,
        Self::StateMachine,
        Self::Values,
        Self::Output,
        Self::Facts,
    ];

    /// The name that settings use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Format => "format",
            Self::Dictionary => "dictionary",
            Self::ProcessData => "process-data",
            Self::StateMachine => "state-machine",
            Self::Values => "values",
            Self::Output => "output",
            Self::Facts => "facts",
            Self::Changes => "changes",
        }
    }

    /// The group of this name.
    pub fn parse(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|group| group.name() == name)
    }
}

impl Level {
    /// The word that settings use.
    pub fn name(self) -> &'static str {
        match self {
            Self::Allow => "allow",
            Self::Warning => "warn",
            Self::Error => "deny",
        }
    }

    /// The word that messages use.
    pub fn word(self) -> &'static str {
        match self {
            Self::Allow => "allow",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }

    /// The level that a setting means.
    pub fn parse(name: &str) -> Option<Self> {
        [Self::Allow, Self::Warning, Self::Error].into_iter().find(|level| level.name() == name)
    }
}

/// Declares a [`Rule`]; its doc comment is the rule's documentation.
macro_rules! rule {
    (
        $(#[doc = $doc:literal])+
        $vis:vis static $id:ident = $name:literal, $group:ident, $level:ident, $summary:literal;
    ) => {
        $(#[doc = $doc])+
        $vis static $id: $crate::diagnostic::Rule = $crate::diagnostic::Rule {
            name: $name,
            group: $crate::diagnostic::Group::$group,
            level: rule!(@level $level),
            fixed: rule!(@fixed $level),
            summary: $summary,
            docs: concat!($($doc, "\n"),+),
        };
    };
    (@level Fatal) => { $crate::diagnostic::Level::Error };
    (@level $level:ident) => { $crate::diagnostic::Level::$level };
    (@fixed Fatal) => { true };
    (@fixed $level:ident) => { false };
}
#[allow(unused_imports)]
pub(crate) use rule;
