//! `devc build`

use std::collections::BTreeMap;
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
use super::watch::watch;
use super::workers::Workers;
use super::workplace::Workplace;
use super::write::{Plan, make_folder};

/// Make the outputs of descriptions.
///
/// The outputs of a description are the files `<OUT>/<name>/<name>.*`, where the name is that of its folder; some outputs
/// make a file of each member of a family, `<OUT>/<name>/<member>.*`.
/// Each is written whole or not at all, and only if it changes. A file that devc did not make is never replaced, and
/// none is removed. A description with errors keeps the outputs it has, and the others are made all the same.
#[derive(Debug, Args)]
pub(super) struct Build {
    /// Folders with a `device.toml`, or TOML files [default: every such folder in `devices`].
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,

    /// The folder for the outputs.
    #[arg(long, short, value_name = "DIR", default_value = "generated")]
    out: PathBuf,

    /// The outputs to make, separated by commas: names, `default` for what is made of itself, or `all`.
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = DEFAULT, value_parser = emitters())]
    emit: Vec<String>,

    /// Leave out of the reference how sure facts are: errata, remarks, assumptions and marks.
    #[arg(long)]
    no_editorial: bool,

    /// Leave the dictionary for a firmware out of Rust: a master needs none.
    #[arg(long)]
    no_dictionary: bool,

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

    /// Build again whenever a file of the descriptions changes, until stopped.
    #[arg(long, conflicts_with = "timings")]
    watch: bool,
}

/// The word for the outputs that are made of themselves, and that for every one.
const DEFAULT: &str = "default";
const ALL: &str = "all";

/// The names of all outputs, with what they are, and the words for several of them.
fn emitters() -> PossibleValuesParser {
    let named = |emitter: &&dyn Emitter| PossibleValue::new(emitter.name()).help(emitter.summary());
    let of_itself: Vec<_> = emit::ALL.iter().filter(|it| it.is_default()).map(|it| it.name()).collect();
    let groups = [
        PossibleValue::new(DEFAULT).help(of_itself.join(", ")),
        PossibleValue::new(ALL).help("every output that there is"),
    ];
    PossibleValuesParser::new(emit::ALL.iter().map(named).chain(groups))
}

/// What was made of a description, before anything of it is said or written.
struct Made {
    compilation: Compilation,
    files: Option<Files>,
    timings: Timings,
}

impl Build {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let paths = descriptions(&self.paths, report)?;
        if self.watch {
            return watch(report, || self.all(&paths, report));
        }
        self.all(&paths, report).map(|(outcome, _)| outcome)
    }

    /// Builds all descriptions once, and tells which files were read.
    fn all(&self, paths: &[PathBuf], report: &Report) -> Result<(Outcome, Vec<PathBuf>), Failure> {
        let levels = self.levels.levels()?;
        // Before anything is read, so that the last of several runs leaves what the descriptions say then.
        let place = if self.check { None } else { Some(self.enter(report)?) };
        let workers = if self.timings { Workers::ONE } else { Workers::all() };
        let mut made = workers.map(paths, |path| self.make(path, &levels, workers));
        let mut outcome = Outcome::Clean;
        let mut built = BTreeMap::new();
        for (path, made) in paths.iter().zip(&mut made) {
            self.limit.cut(&mut made.compilation);
            report.diagnostics(&made.compilation);
            outcome = outcome.max(verdict(&made.compilation, self.levels.deny_warnings));
            let end = self.finish(path, made, &mut built, place.as_ref(), report);
            outcome = outcome.max(end.unwrap_or_else(|failure| report.failure(&failure)));
        }
        let read = made.into_iter().flat_map(|made| made.compilation.files);
        // a description that cannot be read may come to be
        Ok((outcome, read.chain(paths.iter().cloned()).collect()))
    }

    /// Makes the output folder if need be, and holds it.
    fn enter(&self, report: &Report) -> Result<Workplace, Failure> {
        make_folder(&self.out)?;
        Ok(Workplace::enter(&self.out, report))
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
            self.emit.iter().any(|name| match name.as_str() {
                DEFAULT => emitter.is_default(),
                ALL => true,
                name => name == emitter.name(),
            })
        };
        // the last takes longest, so it is begun first
        let emitters: Vec<&dyn Emitter> = emit::ALL.iter().rev().filter(wanted).copied().collect();
        let options = Options { editorial: !self.no_editorial, dictionary: !self.no_dictionary };
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

    /// Compares or writes the outputs of one description, and says what was done.
    fn finish<'m>(
        &self,
        path: &'m Path,
        made: &'m mut Made,
        built: &mut BTreeMap<String, &'m Path>,
        place: Option<&Workplace>,
        report: &Report,
    ) -> Result<Outcome, Failure> {
        let Made { compilation, files, timings } = made;
        let counts = counts(&compilation.diagnostics).map(|counts| format!(", {counts}")).unwrap_or_default();
        let (Some(family), Some(files)) = (&compilation.family, files) else {
            report.line(&format!("{}: nothing made{counts}", path.display()));
            return Ok(Outcome::Clean);
        };
        claim(built, &family.id, path)?;
        timings.enter(if self.check { "compare" } else { "write" });
        let plan = Plan::new(&self.out, &family.id, files)?;
        place.map_or(Ok(()), |place| plan.carry_out(place))?;
        timings.stop();
        let is_done = !self.check || plan.is_empty();
        if !is_done {
            plan.differences().for_each(|difference| report.error(&difference, None));
        }
        let did = if is_done { plan.summary() } else { STALE.to_owned() };
        report.line(&format!("{}: {did}{counts}", path.display()));
        if self.timings {
            report.message(&timings.table(&family.id));
        }
        Ok(if is_done { Outcome::Clean } else { Outcome::Findings })
    }
}

/// What is said of outputs that are only compared.
const STALE: &str = "not up to date, `devc build` makes it so";

/// Two descriptions whose folders share a name would overwrite each other's outputs; on some systems, those too whose
/// names differ in case.
fn claim<'m>(built: &mut BTreeMap<String, &'m Path>, id: &str, path: &'m Path) -> Result<(), Failure> {
    let Some(other) = built.insert(id.to_lowercase(), path) else { return Ok(()) };
    let (one, two) = (other.display(), path.display());
    Err(Failure::new(format!("`{one}` and `{two}` would both be written to the folder `{id}`"))
        .help("rename one of the folders, or build them with different `--out`"))
}
