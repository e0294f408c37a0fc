//! `devc schema`

use clap::Args;
use devc::reference::SCHEMA;

use super::outcome::{Failure, Outcome};
use super::report::Report;

/// Print the JSON schema of descriptions, for editors.
///
/// An editor with support for TOML takes it from a comment at the top of a file: `#:schema device.schema.json`.
#[derive(Debug, Args)]
pub(super) struct Schema {}

impl Schema {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        report.output(SCHEMA);
        Ok(Outcome::Clean)
    }
}
