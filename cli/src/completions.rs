//! `devc completions`

use clap::{Args, CommandFactory};
use clap_complete::{Shell, generate};

use super::Arguments;
use super::outcome::{Failure, Outcome};
use super::report::Report;

/// Print a script that completes the arguments of devc in a shell.
///
/// For bash: `devc completions bash > ~/.local/share/bash-completion/completions/devc`.
#[derive(Debug, Args)]
pub(super) struct Completions {
    /// The shell.
    #[arg(value_name = "SHELL")]
    shell: Shell,
}

impl Completions {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let mut script = Vec::new();
        generate(self.shell, &mut Arguments::command(), "devc", &mut script);
        report.output(&String::from_utf8_lossy(&script));
        Ok(Outcome::Clean)
    }
}
