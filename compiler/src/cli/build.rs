//! `devc build`

use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser};
use devc::emit::{self, Emitter, Files};
use devc::lint::Checked;
use devc::model::Family;
use devc::source::Disk;

use super::levels::LevelArguments;
use super::outcome::{Failure, Outcome};
use super::paths::descriptions;
use super::report::{Report, counts, verdict};
use super::timings::Timings;
use super::write::{Plan, Scope};

/// Make the outputs of descriptions.
///
/// The outputs of a description are the files `<OUT>/<name>/<name>.*`, where the name is that of its folder.
/// Each is written whole or not at all, and only if it changes; files of this name that devc no longer makes
/// are removed. A description with errors keeps the outputs it has, and the others are made all the same.
#[derive(Debug, Args)]
pub(super) struct Build {
    /// Folders with a `device.toml`, or TOML files [default: every such folder in `devices`].
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,

    /// The folder for the outputs.
    #[arg(long, short, value_name = "DIR", default_value = "generated")]
    out: PathBuf,

    /// The outputs to make, separated by commas [default: all].
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = emitters())]
    emit: Vec<String>,

    /// Write nothing; say which outputs are not up to date.
    #[arg(long)]
    check: bool,

    #[command(flatten)]
    levels: LevelArguments,

    /// Print what each stage costs.
    #[arg(long)]
    timings: bool,
}

/// The names of all outputs, with what they are.
fn emitters() -> PossibleValuesParser {
    let values = emit::ALL.iter().map(|emitter| PossibleValue::new(emitter.name()).help(emitter.summary()));
    PossibleValuesParser::new(values)
}

impl Build {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let levels = self.levels.levels()?;
        let mut outcome = Outcome::Clean;
        let mut built: Vec<(String, PathBuf)> = Vec::new();
        for path in descriptions(&self.paths)? {
            let mut timings = Timings::start();
            let compilation =
                devc::compile_with(&Disk, &path, &levels, &mut |stage| timings.enter(stage.name()));
            timings.stop();
            report.diagnostics(&compilation);
            outcome = outcome.max(verdict(&compilation, self.levels.deny_warnings));
            let counts =
                counts(&compilation.diagnostics).map(|counts| format!(", {counts}")).unwrap_or_default();
            let Some(family) = compilation.family else {
                report.line(&format!("{}: nothing made{counts}", path.display()))?;
                continue;
            };
            claim(&mut built, &family.id, &path)?;
            match self.family(&family, report, &mut timings) {
                Ok((found, did)) => {
                    outcome = outcome.max(found);
                    report.line(&format!("{}: {did}{counts}", path.display()))?;
                }
                Err(failure) => outcome = outcome.max(report.failure(&failure)),
            }
            if self.timings {
                report.message(&timings.table(&family.id));
            }
        }
        Ok(outcome)
    }

    /// Makes the outputs of one description, and says what it did.
    fn family(
        &self,
        family: &Checked<Family>,
        report: &Report,
        timings: &mut Timings,
    ) -> Result<(Outcome, String), Failure> {
        let files = self.emit(family, timings);
        timings.enter(if self.check { "compare" } else { "write" });
        let scope = if self.emit.is_empty() { Scope::All } else { Scope::Some };
        let plan = Plan::new(&self.out, &family.id, &files, scope)?;
        if !self.check {
            plan.carry_out()?;
        }
        timings.stop();
        if self.check && !plan.is_empty() {
            for difference in plan.differences() {
                report.error(&difference, None);
            }
            return Ok((Outcome::Findings, "not up to date, `devc build` makes it so".to_owned()));
        }
        Ok((Outcome::Clean, plan.summary()))
    }

    fn emit(&self, family: &Checked<Family>, timings: &mut Timings) -> Files {
        let wanted = |emitter: &&&dyn Emitter| {
            self.emit.is_empty() || self.emit.iter().any(|name| name == emitter.name())
        };
        let mut files = Files::default();
        for emitter in emit::ALL.iter().filter(wanted) {
            timings.enter(emitter.name());
            files.0.extend(emit::emit(family, &[*emitter]).0);
        }
        timings.stop();
        files
    }
}

/// Two descriptions whose folders share a name would overwrite each other's outputs.
fn claim(built: &mut Vec<(String, PathBuf)>, id: &str, path: &Path) -> Result<(), Failure> {
    if let Some((_, other)) = built.iter().find(|(name, _)| name == id) {
        let what = format!(
            "`{}` and `{}` would both be written to the folder `{id}`",
            other.display(),
            path.display()
        );
        return Err(
            Failure::new(what).help("rename one of the folders, or build them with different `--out`")
        );
    }
    built.push((id.to_owned(), path.to_owned()));
    Ok(())
}
