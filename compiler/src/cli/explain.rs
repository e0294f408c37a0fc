//! `devc explain`

use clap::Args;
use devc::explain::{Unknown, explain};

use super::outcome::{Failure, Outcome};
use super::report::Report;

/// Explain a rule, a profile, or what profiles define.
///
/// A rule: why it matters, with an example that breaks it and one that keeps it. A profile: what a description can refer
/// to. An index, a code, an id or a name: what the profiles say of it.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Explain {
    /// A rule, as in the brackets of `error[unknown-key]`; a profile; an index, a code or a name, which a profile and a
    /// word such as `mode` or `error` in front narrow.
    #[arg(required = true, value_name = "WORD", allow_negative_numbers = true)]
    words: Vec<String>,
}

const EXAMPLES: &str = "\
Examples:
  devc explain unknown-key          a rule
  devc explain cia402               a profile
  devc explain 0x6064               an object, an error or an AL status code
  devc explain cia402 0x60FE:01     an entry of an object
  devc explain target position      a thing by its name
  devc explain mode 8               one of several things with this number
  devc explain cia402 errors        all of a kind";

impl Explain {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let answer = explain(&self.words).map_err(|unknown| self.failure(&unknown))?;
        report.line(&answer);
        Ok(Outcome::Clean)
    }

    fn failure(&self, Unknown { near }: &Unknown) -> Failure {
        let names: Vec<String> = near.iter().map(|name| format!("`{name}`")).collect();
        let help = match names.split_last() {
            None => "`devc rules` lists all rules, `devc explain cia402` what is in that profile".to_owned(),
            Some((only, [])) => format!("did you mean {only}?"),
            Some((last, others)) => format!("did you mean {} or {last}?", others.join(", ")),
        };
        Failure::new(format!("nothing is known of `{}`", self.words.join(" "))).help(help)
    }
}
