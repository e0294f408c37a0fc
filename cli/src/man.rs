//! `devc man`

use clap::{Args, CommandFactory};

use super::Arguments;
use super::outcome::{Failure, Outcome};
use super::report::Report;

/// Print a page of the manual: `devc man | man -l -`.
#[derive(Debug, Args)]
pub(super) struct Man {
    /// The command that the page is about [default: devc as a whole].
    #[arg(value_name = "COMMAND")]
    command: Option<String>,
}

impl Man {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let mut devc = Arguments::command();
        devc.build();
        let command = match &self.command {
            None => devc,
            Some(name) => {
                let found = devc.get_subcommands().find(|command| command.get_name() == name);
                found.cloned().ok_or_else(|| {
                    Failure::new(format!("there is no command `{name}`"))
                        .help("`devc help` lists all commands")
                })?
            }
        };
        let mut page = Vec::new();
        clap_mangen::Man::new(command)
            .render(&mut page)
            .map_err(|error| Failure::new(format!("the page cannot be made: {error}")))?;
        report.output(&String::from_utf8_lossy(&page));
        Ok(Outcome::Clean)
    }
}
