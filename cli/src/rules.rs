//! `devc rules`

use clap::Args;

use super::outcome::{Failure, Outcome};
use super::report::Report;

/// List all rules, each with the fault that it finds.
#[derive(Debug, Args)]
pub(super) struct Rules {}

impl Rules {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let rules = devc::rules::all();
        let width = rules.iter().map(|rule| rule.name.len()).max().unwrap_or(0);
        let lines = rules.iter().map(|rule| format!("{:width$}  {}", rule.name, rule.summary));
        report.output(&(lines.collect::<Vec<_>>().join("\n") + "\n"));
        Ok(Outcome::Clean)
    }
}
