//! `devc check`

use std::path::PathBuf;

use clap::Args;
use devc::source::Disk;

use super::outcome::{Failure, Outcome};
use super::paths::descriptions;
use super::report::{Report, counts, verdict};

/// Say what is wrong with descriptions, and write nothing.
#[derive(Debug, Args)]
pub(super) struct Check {
    /// Folders with a `device.toml`, or TOML files [default: every such folder in `devices`].
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,

    /// Count warnings as findings.
    #[arg(long)]
    deny_warnings: bool,
}

impl Check {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let mut outcome = Outcome::Clean;
        for path in descriptions(&self.paths)? {
            let compilation = devc::compile(&Disk, &path);
            report.diagnostics(&compilation);
            let counts = counts(&compilation.diagnostics).unwrap_or_else(|| "no findings".to_owned());
            report.line(&format!("{}: {counts}", path.display()))?;
            outcome = outcome.max(verdict(&compilation, self.deny_warnings));
        }
        Ok(outcome)
    }
}
