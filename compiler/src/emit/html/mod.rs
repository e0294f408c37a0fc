//! The reference as a page: one file that opens from a disk, with a search and decoders.
//!
//! What is to be read is the reference as the Markdown has it, and stays readable without script. The script is given facts as
//! data, and puts them on the page as text only. Nothing is loaded, and the policy of the page forbids it.

mod abort;
mod blocks;
mod data;
mod document;
mod figure;
mod sequences;

use super::{Emitter, Files, Options};
use crate::diagnostic::Rule;
use crate::lint::{Checked, rules};
use crate::model::Family;

/// The emitter of the page.
#[derive(Debug)]
pub struct Html;

/// What it cannot hold.
const LINTS: &[&Rule] = &[&rules::empty_name::RULE];

impl Emitter for Html {
    fn name(&self) -> &'static str {
        "html"
    }

    fn summary(&self) -> &'static str {
        "the reference as a page, with a search and decoders, for the person at the drive"
    }

    fn ends(&self) -> &'static [&'static str] {
        &[".html"]
    }

    fn lints(&self) -> &'static [&'static Rule] {
        LINTS
    }

    fn is_default(&self) -> bool {
        false
    }

    fn emit(&self, family: &Checked<Family>, options: &Options) -> Files {
        Files::one(format!("{}.html", family.id), document::document(family, options.editorial))
    }
}
