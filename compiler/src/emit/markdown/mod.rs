//! The reference chapter of a manual, in Markdown.
//!
//! Each chapter is a *view*, a struct that holds what is to be printed and decides what is not, and a template
//! that says in what order and under which headings. A view that is not there takes its line of the contents
//! with it.

mod chapter;
mod chapters;
mod context;
mod document;
mod family;
mod inline;
mod number;
mod table;

#[cfg(feature = "diff")]
pub(crate) use inline::text as escaped;

use super::{Emitter, Files, Options};
use crate::lint::Checked;
use crate::model::Family;
use crate::text::characters::harmless;

/// The emitter of the reference.
#[derive(Debug)]
pub struct Markdown;

impl Emitter for Markdown {
    fn name(&self) -> &'static str {
        "md"
    }

    fn summary(&self) -> &'static str {
        "the reference chapter of a manual"
    }

    fn ends(&self) -> &'static [&'static str] {
        &[".md"]
    }

    fn is_default(&self) -> bool {
        true
    }

    fn emit(&self, family: &Checked<Family>, options: &Options) -> Files {
        Files::one(
            format!("{}.md", family.id),
            harmless(&document::document(family, options.editorial)).into_owned(),
        )
    }
}
