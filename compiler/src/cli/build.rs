//! `devc build`

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser};
use devc::Compilation;
use devc::emit::{self, Emitter, Files, Options};
use devc::lint::{Checked, Levels};
use devc::model::Family;
use devc::source::Disk;

use super::levels::LevelArguments;
use super::limit::Limit;
use super::outcome::{Failure, Outcome};
use super::paths::descriptions;
use super::report::{Report, counts, verdict};
use super::timings::Timings;
use super::workers::Workers;
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

    /// Leave out of the reference how sure facts are: errata, remarks, assumptions and marks.
    #[arg(long)]
    no_editorial: bool,

    /// Write nothing; say which outputs are not up to date.
    #[arg(long)]
    check: bool,

    #[command(flatten)]
    levels: LevelArguments,

    #[command(flatten)]
    limit: Limit,

    /// Print what each stage costs, on one core.
    #[arg(long)]
    timings: bool,
}

/// The names of all outputs, with what they are.
fn emitters() -> PossibleValuesParser {
    let values = emit::ALL.iter().map(|emitter| PossibleValue::new(emitter.name()).help(emitter.summary()));
    PossibleValuesParser::new(values)
}

/// What was made of a description, before anything of it is said or written.
struct Made {
    compilation: Compilation,
    files: Option<Files>,
    timings: Timings,
}

impl Build {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let levels = self.levels.levels()?;
        let paths = descriptions(&self.paths)?;
        let workers = if self.timings { Workers::ONE } else { Workers::all() };
        let mut made = workers.map(&paths, |path| self.make(path, &levels, workers));
        let mut outcome = Outcome::Clean;
        let mut built: Vec<(&str, &Path)> = Vec::new();
        for (path, Made { compilation, files, timings }) in paths.iter().zip(&mut made) {
            self.limit.cut(compilation);
            let (compilation, files) = (&*compilation, &*files);
            report.diagnostics(compilation);
            outcome = outcome.max(verdict(compilation, self.levels.deny_warnings));
            let counts =
                counts(&compilation.diagnostics).map(|counts| format!(", {counts}")).unwrap_or_default();
            let (Some(family), Some(files)) = (&compilation.family, files) else {
                report.line(&format!("{}: nothing made{counts}", path.display()))?;
                continue;
            };
            claim(&mut built, &family.id, path)?;
            match self.write(&family.id, files, report, timings) {
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

    /// Compiles a description and makes its outputs.
    fn make(&self, path: &Path, levels: &Levels, workers: Workers) -> Made {
        let mut timings = Timings::start();
        let compilation = devc::compile_with(&Disk, path, levels, &mut |stage| timings.enter(stage.name()));
        timings.stop();
        let files = compilation.family.as_ref().map(|family| self.emit(family, &mut timings, workers));
        Made { compilation, files, timings }
    }

    fn emit(&self, family: &Checked<Family>, timings: &mut Timings, workers: Workers) -> Files {
        let wanted = |emitter: &&&dyn Emitter| {
            self.emit.is_empty() || self.emit.iter().any(|name| name == emitter.name())
        };
        // the last takes longest, so it is begun first
        let emitters: Vec<&dyn Emitter> = emit::ALL.iter().rev().filter(wanted).copied().collect();
        let options = Options { editorial: !self.no_editorial };
        let made = workers.map(&emitters, |emitter| {
            let start = Instant::now();
            (emit::emit(family, &[*emitter], &options), start.elapsed())
        });
        let mut files = Files::default();
        for (emitter, (made, time)) in emitters.iter().zip(made).rev() {
            timings.add(emitter.name(), time);
            files.0.extend(made.0);
        }
        files
    }

    /// Writes the outputs of one description, and says what it did.
    fn write(
        &self,
        id: &str,
        files: &Files,
        report: &Report,
        timings: &mut Timings,
    ) -> Result<(Outcome, String), Failure> {
        timings.enter(if self.check { "compare" } else { "write" });
        let scope = if self.emit.is_empty() { Scope::All } else { Scope::Some };
        let plan = Plan::new(&self.out, id, files, scope)?;
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
}

/// Two descriptions whose folders share a name would overwrite each other's outputs.
fn claim<'a>(built: &mut Vec<(&'a str, &'a Path)>, id: &'a str, path: &'a Path) -> Result<(), Failure> {
    if let Some((_, other)) = built.iter().find(|(name, _)| *name == id) {
        let what = format!(
            "`{}` and `{}` would both be written to the folder `{id}`",
            other.display(),
            path.display()
        );
        return Err(
            Failure::new(what).help("rename one of the folders, or build them with different `--out`")
        );
    }
    built.push((id, path));
    Ok(())
}
