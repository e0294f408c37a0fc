//! The reference chapter of a manual, in Markdown.
//!
//! Each chapter puts down blocks on a page: headings, paragraphs, lists, tables. What is empty leaves no block, and a chapter
//! without blocks takes its line of the contents with it. The references of a family become one block by block.

mod chapters;
mod context;
mod document;
mod family;
mod holds;
mod inline;
mod machine;
mod number;
mod page;
mod picture;
mod table;

#[cfg(feature = "html")]
pub(super) use document::{body, front};
#[cfg(feature = "html")]
pub(super) use holds::{Form, Holds};
#[cfg(feature = "diff")]
pub(crate) use inline::text as escaped;
#[cfg(feature = "html")]
pub(super) use machine::{Arrow, Label, Machine, Node};
#[cfg(feature = "html")]
pub(super) use page::{Block, Heading, Page};
#[cfg(feature = "html")]
pub(super) use picture::{Area, Light, Part, Picture};
#[cfg(feature = "html")]
pub(super) use table::{Row, Table};

use super::{Emitter, Files, Options};
use crate::diagnostic::Rule;
use crate::lint::{Checked, rules};
use crate::model::Family;
use crate::text::characters::harmless;

/// The emitter of the reference.
#[derive(Debug)]
pub struct Markdown;

/// What it cannot hold.
const LINTS: &[&Rule] = &[&rules::empty_name::RULE];

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

    fn lints(&self) -> &'static [&'static Rule] {
        LINTS
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
