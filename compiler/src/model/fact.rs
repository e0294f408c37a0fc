//! How sure a statement is.

use super::model;
use crate::source::Origin;

model! {
    /// A document that facts are taken from.
    pub struct Document {
        /// The word for it.
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

    /// A place in a document.
    #[derive(Eq)]
    pub struct Source {
        /// The document, by id; none for the main one if no document is listed.
        pub document: Option<String>,
        /// The place.
        pub place: String,
    }

    /// Something that no source states.
    pub struct Assumption {
        /// What it is about, such as `identity.revision`.
        pub at: String,
        /// What is taken to be so, if it is a single value.
        pub value: Option<String>,
        /// Why.
        pub reason: String,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }

    /// The answer to one finding of one rule.
    pub struct Erratum {
        /// The rule.
        pub rule: String,
        /// What it was found at.
        pub at: String,
        /// What the manual says.
        pub says: String,
        /// What is so.
        pub holds: String,
        /// How one knows.
        pub why: String,
        /// Where the manual says it.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }

    /// A weakness of the sources that no rule can see.
    pub struct Remark {
        /// What it is about.
        pub at: String,
        /// What is weak.
        pub kind: RemarkKind,
        /// What there is to know.
        pub text: String,
        /// Where the weakness is.
        pub source: Option<Source>,
    }

    /// What is weak.
    #[derive(Copy, Eq)]
    #[cfg_attr(feature = "json", serde(rename_all = "snake_case"))]
    pub enum RemarkKind {
        /// Two places disagree.
        Contradiction,
        /// No place says it.
        Silence,
        /// A place can be read in two ways, or is hard to believe.
        Doubt,
    }
}
