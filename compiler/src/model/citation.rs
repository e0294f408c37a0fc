//! Where in a document a fact is from.

use std::fmt;

use super::plain;

plain! {
    /// A place in a document.
    #[derive(Eq)]
    pub struct Source {
        /// The document, by id; none for the main one if no document is listed.
        pub document: Option<String>,
        /// The place.
        pub place: String,
    }
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.document {
            Some(document) => write!(f, "{document}: {}", self.place),
            None => f.write_str(&self.place),
        }
    }
}
