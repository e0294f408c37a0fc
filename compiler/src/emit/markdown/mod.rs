//! The reference chapter of a manual, in Markdown.
//!
//! Each chapter puts down blocks on a page: headings, paragraphs, lists, tables. What is empty leaves no block, and a chapter
//! without blocks takes its line of the contents with it. The references of a family become one block by block.

mod chapters;
mod context;
mod divided;
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

/// The document, and the chapters where each is a file.
const ENDS: &[&str] = &[
    ".md",
    ".md.d/device.md",
    ".md.d/axes.md",
    ".md.d/connections.md",
    ".md.d/communication.md",
    ".md.d/synchronisation.md",
    ".md.d/process-data.md",
    ".md.d/configurations.md",
    ".md.d/words.md",
    ".md.d/states.md",
    ".md.d/modes.md",
    ".md.d/homing.md",
    ".md.d/stopping.md",
    ".md.d/errors.md",
    ".md.d/units.md",
    ".md.d/coordinates.md",
    ".md.d/objects.md",
    ".md.d/registers.md",
    ".md.d/service.md",
    ".md.d/sources.md",
];

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
        ENDS
    }

    fn lints(&self) -> &'static [&'static Rule] {
        LINTS
    }

    fn is_default(&self) -> bool {
        true
    }

    fn emit(&self, family: &Checked<Family>, options: &Options) -> Files {
        if options.chapters {
            return divided::files(family, options.editorial);
        }
        Files::one(
            format!("{}.md", family.id),
            harmless(&document::document(family, options.editorial)).into_owned(),
        )
    }
}
