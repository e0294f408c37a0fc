//! One change, and what kind it is.

use crate::diagnostic::{Level, Rule};
use crate::model::{Difference, Place};
use crate::source::Location;

/// Whom a change breaks, the worst last.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "json", derive(serde::Serialize))]
#[cfg_attr(feature = "json", serde(rename_all = "kebab-case"))]
pub enum Class {
    /// Nobody: only people and generated names notice.
    Documentation,
    /// Nobody: what was made for the old version does not notice.
    Compatible,
    /// What runs still runs, but start-up settings, tools or limits fail or behave otherwise.
    ConfigurationBreaking,
    /// The new device refuses what was made for the old one, or both exchange the wrong bytes.
    WireBreaking,
}

/// A kind of change.
///
/// Made with `kinds!`, which takes the documentation from the doc comment.
#[derive(Debug, PartialEq, Eq)]
pub struct Kind {
    /// What messages about such changes name: the change in kebab case, and all there is to say about it in general.
    pub rule: Rule,
    /// Whom it breaks.
    pub class: Class,
}

/// A change from one version of a device to the next.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Change {
    /// What kind it is.
    pub kind: &'static Kind,
    /// What changes; on the first axis, if it changes on several alike.
    pub at: Place,
    /// Its name, if it has one.
    pub name: Option<String>,
    /// What it was; none if it was not there.
    pub old: Option<String>,
    /// What it is; none if it is gone.
    pub new: Option<String>,
    /// On how many axes it changes alike.
    pub axes: usize,
    /// In which devices of the comparison it changes alike, by number.
    pub devices: Vec<usize>,
    /// Where the old version says it.
    pub old_at: Option<Location>,
    /// Where the new version says it.
    pub new_at: Option<Location>,
}

impl Kind {
    /// The documentation, without the space that a doc comment puts before each line.
    pub fn text(&self) -> String {
        let lines: Vec<&str> = self.rule.docs.lines().map(str::trim).collect();
        lines.join("\n").trim().to_owned()
    }
}

impl Change {
    /// A change of which nothing else is known.
    pub(super) fn new(kind: &'static Kind, at: Place) -> Self {
        Self {
            kind,
            at,
            name: None,
            old: None,
            new: None,
            axes: 1,
            devices: Vec::new(),
            old_at: None,
            new_at: None,
        }
    }

    /// The change that a difference is.
    pub(super) fn of(kind: &'static Kind, at: Place, difference: &Difference) -> Self {
        let Difference { path: _, is_order: _, first, second, first_at, second_at } = difference.clone();
        Self { old: first, new: second, old_at: first_at, new_at: second_at, ..Self::new(kind, at) }
    }
}

impl Class {
    /// All of them, the worst first.
    pub const ALL: [Self; 4] =
        [Self::WireBreaking, Self::ConfigurationBreaking, Self::Compatible, Self::Documentation];

    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::WireBreaking => "wire-breaking",
            Self::ConfigurationBreaking => "configuration-breaking",
            Self::Compatible => "compatible",
            Self::Documentation => "documentation",
        }
    }

    /// How bad it is if nobody says what is denied: what breaks nothing is a remark.
    pub const fn level(self) -> Level {
        match self {
            Self::WireBreaking | Self::ConfigurationBreaking => Level::Warning,
            Self::Compatible | Self::Documentation => Level::Allow,
        }
    }

    /// What it means, in a line.
    pub fn about(self) -> &'static str {
        match self {
            Self::WireBreaking => {
                "what was made for the old version is refused, or the wrong bytes are exchanged"
            }
            Self::ConfigurationBreaking => "start-up settings, tools or limits fail or behave otherwise",
            Self::Compatible => "what was made for the old version does not notice",
            Self::Documentation => "only people and generated names notice",
        }
    }
}
