//! `devc explain`

use clap::Args;
use devc::rules;

use super::outcome::{Failure, Outcome};
use super::report::Report;

/// Explain a rule: why it matters, with an example that breaks it and one that keeps it.
#[derive(Debug, Args)]
pub(super) struct Explain {
    /// The name that a message has in its brackets, as in `error[unknown-key]`.
    rule: String,
}

impl Explain {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let rule = rules::find(&self.rule).map_err(|near| {
            Failure::new(format!("there is no rule `{}`", self.rule)).help(match near {
                Some(near) => format!("did you mean `{near}`?"),
                None => "`devc rules` lists all rules".to_owned(),
            })
        })?;
        let (summary, level, docs) = (rule.summary, rules::default_level(rule), rules::docs(rule));
        report.line(&format!("{}: {summary} ({level})\n\n{docs}", rule.name))?;
        Ok(Outcome::Clean)
    }
}
