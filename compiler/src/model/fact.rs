//! How sure a statement is.

use super::table::{part, table};
use super::{Compare, Difference, FieldPath, Place, Said, model};

use crate::source::{Location, Origin};

table! {
    /// `[documents.<id>]`: a document that facts are taken from.
    pub struct Document by id: "a word" {
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// Its title.
        pub title: String,
        /// Its number.
        pub number: Option<String>,
        /// Its edition or date.
        pub edition: Option<String>,
        /// Who published it.
        pub publisher: Option<String>,
        /// What it is good for.
        pub about: Option<String>,
    }

    /// `[[errata]]`: the answer to one finding of one rule.
    pub struct Erratum {
        /// The rule that found it.
        pub rule: String,
        /// What it was found at, as the message names it.
        pub at: Place,
        /// What the source says there, as the description has it: the value, or keys with their values.
        pub says: Said,
        /// What is so: as `says`; outputs use it. Left out if nobody knows: outputs then mark what is said.
        pub holds: Option<Said>,
        /// Whether the device is as the source says, unlike the profile or other devices.
        #[serde(default)]
        pub stands: bool,
        /// How one knows.
        pub why: String,
    }

    /// `[[remarks]]`: a weakness of the sources that no rule can see.
    pub struct Remark {
        /// What it is about, as an erratum would name it.
        pub at: Place,
        /// Whether the sources contradict each other, say nothing, or can be read in two ways.
        pub kind: RemarkKind,
        /// What there is to know.
        pub text: String,
    }
}

part! {
    /// What is weak.
    #[derive(Copy, Eq, Default)]
    pub enum RemarkKind {
        /// Two places disagree.
        Contradiction,
        /// No place says it.
        Silence,
        /// A place can be read in two ways, or is hard to believe.
        #[default]
        Doubt,
    }
}

model! {
    /// Something that no source states.
    pub struct Assumption by at {
        /// What it is about.
        pub at: Place,
        /// The key that is assumed, as it was written; none if the whole table is.
        #[cfg_attr(feature = "json", serde(skip))]
        pub key: Option<String>,
        /// The keys that its table can have, if the one that is assumed is not there.
        #[cfg_attr(feature = "json", serde(skip))]
        pub keys: Vec<String>,
        /// What is taken to be so, if it is a single value.
        pub value: Option<String>,
        /// Why.
        pub reason: String,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }
}

impl Assumption {
    /// Where the reason was written.
    pub fn reason_at(&self) -> Location {
        let assumed = self.origin.node("assumed");
        let reason = assumed.and_then(|assumed| match &self.key {
            Some(key) => assumed.table()?.get(key).map(|member| member.node.at),
            None => Some(assumed.at),
        });
        reason.unwrap_or(self.origin.header())
    }
}

/// A table of a section as it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct Written {
    /// What it is about.
    pub place: Place,
    /// Whether it says where its facts are from.
    pub sourced: bool,
    /// Whether all of it is assumed.
    pub assumed: bool,
    /// Where its key stands, and what it says.
    pub origin: Origin,
}

/// Every table of a description, as it was written.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Tables(pub Vec<Written>);

/// Where a thing was written is not part of what it is.
impl Compare for Tables {
    fn shown(&self) -> String {
        String::new()
    }

    fn compare(&self, _: &Self, _: &mut FieldPath, _: &mut dyn FnMut(Difference)) {}
}
