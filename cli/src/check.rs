//! `devc check`

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use devc::diagnostic::{Diagnostics, render};
use devc::source::{Disk, Sources};
use devc::text::characters::line;
use devc::{Compilation, Request, emit, rules};

use super::baseline::Baseline;
use super::fix::fix;
use super::levels::LevelArguments;
use super::limit::Limit;
use super::outcome::{Failure, Outcome};
use super::paths::descriptions;
use super::project::Project;
use super::report::{Report, counts, number, verdict};
use super::workers::Workers;

/// Say what is wrong with descriptions, and write nothing.
///
/// What an output cannot hold is said of those that are made without being asked for and of those that `devc.toml` names.
#[derive(Debug, Args)]
pub(super) struct Check {
    /// Folders with a `device.toml`, or TOML files [default: this one, or every such folder in `devices`].
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,

    /// How to say it; all but `text` go to the standard output.
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    format: Format,

    #[command(flatten)]
    levels: LevelArguments,

    #[command(flatten)]
    limit: Limit,

    /// Report only what is not in this file.
    #[arg(long, value_name = "FILE")]
    baseline: Option<PathBuf>,

    /// Write all findings to the baseline, so that only what comes later is reported.
    #[arg(long, requires = "baseline")]
    update_baseline: bool,

    /// Make the edits that are beyond doubt, such as the right spelling of a name.
    #[arg(long, conflicts_with = "update_baseline")]
    fix: bool,
}

/// How findings are said.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people.
    Text,
    /// For programs; version 1 of the format is frozen.
    Json,
    /// For code scanning: SARIF 2.1.0.
    Sarif,
    /// For pull requests on GitHub.
    Github,
}

impl Check {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let outputs = emit::lints(Project::here(report)?.checked());
        let request = Request { levels: self.levels.levels()?, outputs };
        let compile = |path: &PathBuf| devc::compile_with(&Disk, path, &request, &mut |_| ());
        let paths = descriptions(&self.paths, report)?;
        let mut outcome = Outcome::Clean;
        for path in paths.iter().filter(|_| self.fix) {
            match fix(&compile(path), report) {
                Ok(0) => {}
                Ok(made) => {
                    report.message(&line(&format!("{}: made {}", path.display(), number(made, "edit"))));
                }
                Err(failure) => outcome = report.failure(&failure),
            }
        }
        let compiled = Workers::all().map(&paths, compile);
        let mut compilations: Vec<(PathBuf, Compilation)> = paths.into_iter().zip(compiled).collect();
        if let Some(path) = &self.baseline {
            if self.update_baseline {
                return update(path, &compilations, report);
            }
            let mut baseline = Baseline::read(path)?;
            compilations.iter_mut().for_each(|(_, compilation)| baseline.forget(compilation));
        }
        for (_, compilation) in &mut compilations {
            match self.format {
                Format::Text | Format::Github => self.limit.cut(compilation),
                Format::Json | Format::Sarif => self.limit.cut_for_programs(compilation),
            }
        }
        self.say(&compilations, report);
        let verdicts = compilations.iter().map(|(_, c)| verdict(c, self.levels.deny_warnings));
        Ok(verdicts.fold(outcome, Outcome::max))
    }

    fn say(&self, compilations: &[(PathBuf, Compilation)], report: &Report) {
        let runs: Vec<(&Diagnostics, &Sources)> =
            compilations.iter().map(|(_, c)| (&c.diagnostics, &c.sources)).collect();
        let text = match self.format {
            Format::Text => return people(compilations, self.baseline.is_some(), report),
            Format::Json => render::json(&runs),
            Format::Sarif => render::sarif(&runs, &rules::all()),
            Format::Github => {
                runs.iter().map(|(diagnostics, sources)| render::github(diagnostics, sources)).collect()
            }
        };
        report.output(&text);
    }
}

fn people(compilations: &[(PathBuf, Compilation)], only_new: bool, report: &Report) {
    let none = if only_new { "no new findings" } else { "no findings" };
    for (path, compilation) in compilations {
        report.diagnostics(compilation);
        let counts = counts(&compilation.diagnostics).unwrap_or_else(|| none.to_owned());
        report.line(&format!("{}: {counts}", path.display()));
    }
}

fn update(path: &Path, compilations: &[(PathBuf, Compilation)], report: &Report) -> Result<Outcome, Failure> {
    let mut baseline = Baseline::default();
    for (_, compilation) in compilations {
        baseline.learn(compilation);
    }
    baseline.write(path, report)?;
    report.line(&format!("{}: {}", path.display(), number(baseline.len(), "known finding")));
    Ok(Outcome::Clean)
}
