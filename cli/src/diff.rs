//! `devc diff`

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use devc::Compilation;
use devc::diagnostic::render;
use devc::diff::{Class, Comparison, compare, findings, gate, json, markdown, rules, text};
use devc::import::Choice;
use devc::lint::Checked;
use devc::model::Family;
use devc::source::Disk;

use super::git;
use super::import::imported;
use super::limit::Limit;
use super::outcome::{Failure, Outcome};
use super::report::Report;

/// Say what changes from one version of a description to the next, and whom it breaks.
///
/// A change is judged from the view of an old configuration on the new device, and named by its kind, which `devc explain`
/// knows.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Diff {
    /// The old version: the folder of a description, a TOML file, or an ESI file. Or two revisions of git, as `main..HEAD`;
    /// without the second one, the files as they are.
    #[arg(value_name = "OLD")]
    old: PathBuf,

    /// The new version; or what the revisions are of.
    #[arg(value_name = "NEW")]
    new: PathBuf,

    /// How to say it.
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    format: Format,

    /// The least class of change that is listed in text.
    #[arg(long, value_name = "CLASS", default_value = "documentation")]
    show: ClassArgument,

    /// The least class of change that is an error (exit code 1).
    #[arg(long, value_name = "CLASS", default_value = "configuration-breaking", conflicts_with = "gate")]
    deny: ClassArgument,

    /// Accept changes that break something if the revision number rises, and never accept one that falls.
    #[arg(long)]
    gate: bool,
}

const EXAMPLES: &str = "\
Examples:
  devc diff old/c887 new/c887                 two folders
  devc diff old/c887.xml devices/c887         what an ESI file says, against a description
  devc diff main..HEAD devices/c887           two revisions of git
  devc diff v1.2.. devices/c887 --gate        from a revision to the files as they are, as a gate in a pipeline
  devc diff v1.2.. devices/c887 --format markdown
                                              a section for a changelog
  devc explain changed-type                   what a kind of change means

Exit codes:
  0  nothing changes that is not allowed
  1  something changes that breaks configurations or programs, or that the gate does not let pass
  2  a version cannot be read";

/// How changes are said.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people.
    Text,
    /// For programs.
    Json,
    /// For a changelog.
    Markdown,
    /// For code scanning: SARIF 2.1.0.
    Sarif,
    /// For pull requests on GitHub.
    Github,
}

/// A class of change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum ClassArgument {
    /// Only people and generated names notice.
    Documentation,
    /// What was made for the old version does not notice.
    Compatible,
    /// Start-up settings, tools or limits fail or behave otherwise.
    ConfigurationBreaking,
    /// What was made for the old version is refused, or the wrong bytes are exchanged.
    WireBreaking,
}

impl From<ClassArgument> for Class {
    fn from(class: ClassArgument) -> Self {
        match class {
            ClassArgument::Documentation => Self::Documentation,
            ClassArgument::Compatible => Self::Compatible,
            ClassArgument::ConfigurationBreaking => Self::ConfigurationBreaking,
            ClassArgument::WireBreaking => Self::WireBreaking,
        }
    }
}

impl Diff {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let [old, new] = self.versions()?;
        let [before, after] = [family(&old, report)?, family(&new, report)?];
        let comparison = compare(before, after);
        let findings = || findings(&comparison, &old.sources, &new.sources, self.least(&comparison));
        report.output(&match self.format {
            Format::Sarif => render::sarif(&[(&findings(), &new.sources)], &rules()),
            Format::Github => render::github(&findings(), &new.sources),
            Format::Text => text(&comparison, &old.sources, &new.sources, self.show.into()),
            Format::Markdown => markdown(&comparison),
            Format::Json => json(&comparison, &old.sources, &new.sources),
        });
        Ok(if self.gate { through(&comparison, report) } else { self.denied(&comparison) })
    }

    /// Both versions, compiled.
    fn versions(&self) -> Result<[Compilation; 2], Failure> {
        let revisions = self.old.to_str().and_then(|old| old.split_once("..")).filter(|_| !self.old.exists());
        let Some((old, new)) = revisions else { return Ok([read(&self.old)?, read(&self.new)?]) };
        let old = if old.is_empty() { "HEAD" } else { old };
        let new = if new.is_empty() { read(&self.new)? } else { committed(new, &self.new)? };
        Ok([committed(old, &self.new)?, new])
    }

    /// The least class of change that is an error; none if the gate lets all pass.
    fn least(&self, comparison: &Comparison) -> Option<Class> {
        match self.gate {
            false => Some(self.deny.into()),
            true => {
                let is_stopped = gate(comparison).iter().any(|gate| gate.complaint().is_some());
                is_stopped.then_some(Class::ConfigurationBreaking)
            }
        }
    }

    fn denied(&self, comparison: &Comparison) -> Outcome {
        let is_denied = comparison.worst().is_some_and(|worst| worst >= self.deny.into());
        if is_denied { Outcome::Findings } else { Outcome::Clean }
    }
}

/// A description; or an ESI file, as `devc import` reads it.
fn read(path: &Path) -> Result<Compilation, Failure> {
    if path.extension().is_none_or(|extension| extension != "xml") {
        return Ok(cut(devc::compile(&Disk, path)));
    }
    let imported = imported(path, Some("the ESI file"), &Choice::default())?;
    Ok(cut(devc::compile(&imported.in_memory(path), path)))
}

fn committed(revision: &str, path: &Path) -> Result<Compilation, Failure> {
    let (files, path) = git::description(revision, path)?;
    Ok(cut(devc::compile(&files, &path)))
}

/// A version with as many messages as people read.
fn cut(mut compilation: Compilation) -> Compilation {
    Limit::default().cut(&mut compilation);
    compilation
}

/// The devices of a version; its messages, if it has errors.
fn family<'c>(version: &'c Compilation, report: &Report) -> Result<&'c Checked<Family>, Failure> {
    version.family.as_ref().ok_or_else(|| {
        report.diagnostics(version);
        Failure::new("versions can be compared when both are without errors")
    })
}

/// Whether the revision numbers say what has changed.
fn through(comparison: &Comparison, report: &Report) -> Outcome {
    let complaints: Vec<(String, String)> =
        gate(comparison).iter().filter_map(|gate| gate.complaint()).collect();
    complaints.iter().for_each(|(what, help)| report.error(what, Some(help)));
    if complaints.is_empty() { Outcome::Clean } else { Outcome::Findings }
}
