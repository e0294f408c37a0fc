//! `devc build`

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser};
use devc::emit::{self, Emitter, Files, Options};
use devc::lint::Checked;
use devc::model::Family;
use devc::source::Disk;
use devc::{Compilation, Request};

use super::folders::Folders;
use super::levels::LevelArguments;
use super::limit::Limit;
use super::outcome::{Failure, Outcome};
use super::paths::descriptions;
use super::project::Project;
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
    /// Folders with a `device.toml`, or TOML files [default: this one, or every such folder in `devices`].
    #[arg(value_name = "PATH")]
    paths: Vec<PathBuf>,

    /// The folder for the outputs [default: what `devc.toml` says, or `generated`].
    #[arg(long, short, value_name = "DIR")]
    out: Option<PathBuf>,

    /// The outputs to make, separated by commas: names, `default` for what is made of itself, or `all`
    /// [default: what `devc.toml` says, or `default`].
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = emitters())]
    emit: Vec<String>,

    /// Leave out of the reference how sure facts are: errata, remarks, assumptions and marks.
    #[arg(long)]
    no_editorial: bool,

    /// Leave the dictionary for a firmware out of Rust: a master needs none.
    #[arg(long)]
    no_dictionary: bool,

    /// Make a file of each chapter of the reference in Markdown, in `<name>.md.d`.
    #[arg(long)]
    chapters: bool,

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

/// The names of all outputs, with what they are, and the words for several of them.
fn emitters() -> PossibleValuesParser {
    let named = |emitter: &&dyn Emitter| PossibleValue::new(emitter.name()).help(emitter.summary());
    let of_itself: Vec<_> = emit::default().map(|it| it.name()).collect();
    let groups = [
        PossibleValue::new(emit::DEFAULT).help(of_itself.join(", ")),
        PossibleValue::new(emit::EVERY).help("every output that there is"),
    ];
    PossibleValuesParser::new(emit::ALL.iter().map(named).chain(groups))
}

/// What is to be made, and where.
struct Order {
    request: Request,
    emitters: Vec<&'static dyn Emitter>,
    options: Options,
    folders: Folders,
}

/// What was made of a description, before anything of it is said or written.
struct Made {
    compilation: Compilation,
    /// The files of each output folder.
    files: Option<BTreeMap<PathBuf, Files>>,
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

    /// What the command line says, and where it says nothing the project.
    fn order(&self, project: &Project) -> Result<Order, Failure> {
        let emitters = match self.emit.as_slice() {
            [] => project.emitters(),
            words => emit::wanted(words.iter().map(String::as_str)),
        };
        let editorial = !self.no_editorial && project.outputs.editorial.unwrap_or(true);
        let dictionary = !self.no_dictionary && project.outputs.dictionary.unwrap_or(true);
        let chapters = self.chapters || project.outputs.chapters.unwrap_or(false);
        let outputs = emit::lints(emitters.iter().copied());
        Ok(Order {
            request: Request { levels: self.levels.levels()?, outputs },
            emitters,
            options: Options { editorial, dictionary, chapters },
            folders: Folders::new(self.out.as_deref(), project),
        })
    }

    /// Builds all descriptions once, and tells which files were read.
    fn all(&self, paths: &[PathBuf], report: &Report) -> Result<(Outcome, Vec<PathBuf>), Failure> {
        let project = Project::here(report)?;
        let order = self.order(&project)?;
        // Before anything is read, so that the last of several runs leaves what the descriptions say then.
        let places = if self.check { None } else { Some(order.enter(report)?) };
        let workers = if self.timings { Workers::ONE } else { Workers::all() };
        let mut made = workers.map(paths, |path| order.make(path, workers));
        let mut outcome = Outcome::Clean;
        let mut built = BTreeMap::new();
        for (path, made) in paths.iter().zip(&mut made) {
            self.limit.cut(&mut made.compilation);
            report.diagnostics(&made.compilation);
            outcome = outcome.max(verdict(&made.compilation, self.levels.deny_warnings));
            let end = self.finish(path, made, &mut built, places.as_ref(), report);
            outcome = outcome.max(end.unwrap_or_else(|failure| report.failure(&failure)));
        }
        let read = made.into_iter().flat_map(|made| made.compilation.files).chain(project.file);
        // a description that cannot be read may come to be
        Ok((outcome, read.chain(paths.iter().cloned()).collect()))
    }

    /// Compares or writes the outputs of one description, and says what was done.
    fn finish<'m>(
        &self,
        path: &'m Path,
        made: &'m mut Made,
        built: &mut BTreeMap<String, &'m Path>,
        places: Option<&BTreeMap<PathBuf, Workplace>>,
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
        let plans = files.iter_mut().map(|(out, files)| Plan::new(out, &family.id, files));
        let plans = plans.collect::<Result<Vec<Plan<'_>>, Failure>>()?;
        for plan in &plans {
            places.and_then(|places| places.get(plan.out())).map_or(Ok(()), |place| plan.carry_out(place))?;
        }
        timings.stop();
        let is_done = !self.check || plans.iter().all(Plan::is_empty);
        if !is_done {
            plans.iter().flat_map(Plan::differences).for_each(|it| report.error(&it, None));
        }
        let did = if is_done { summary(&plans) } else { STALE.to_owned() };
        report.line(&format!("{}: {did}{counts}", path.display()));
        if self.timings {
            report.message(&timings.table(&family.id));
        }
        Ok(if is_done { Outcome::Clean } else { Outcome::Findings })
    }
}

impl Order {
    /// Makes the output folders if need be, and holds them, in an order that is always the same.
    fn enter(&self, report: &Report) -> Result<BTreeMap<PathBuf, Workplace>, Failure> {
        let folders = self.folders.all(&self.emitters).into_iter();
        let enter = |folder: PathBuf| {
            make_folder(&folder)?;
            let place = Workplace::enter(&folder, report);
            Ok((folder, place))
        };
        folders.map(enter).collect()
    }

    /// Compiles a description and makes its outputs.
    fn make(&self, path: &Path, workers: Workers) -> Made {
        let mut timings = Timings::start();
        let enter = &mut |stage: devc::Stage| timings.enter(stage.name());
        let compilation = devc::compile_with(&Disk, path, &self.request, enter);
        timings.stop();
        let files = compilation.family.as_ref().map(|family| self.emit(family, &mut timings, workers));
        Made { compilation, files, timings }
    }

    fn emit(
        &self,
        family: &Checked<Family>,
        timings: &mut Timings,
        workers: Workers,
    ) -> BTreeMap<PathBuf, Files> {
        // the last takes longest, so it is begun first
        let emitters: Vec<&dyn Emitter> = self.emitters.iter().rev().copied().collect();
        let made = workers.map(&emitters, |emitter| {
            let start = Instant::now();
            (emit::emit(family, &[*emitter], &self.options), start.elapsed())
        });
        let mut files: BTreeMap<PathBuf, Files> = BTreeMap::new();
        for (emitter, (made, time)) in emitters.iter().zip(made).rev() {
            timings.add(emitter.name(), time);
            files.entry(self.folders.of(*emitter)).or_default().0.extend(made.0);
        }
        files
    }
}

/// What was done in all folders.
fn summary(plans: &[Plan<'_>]) -> String {
    match plans {
        [] => "no output is wanted".to_owned(),
        plans => plans.iter().map(Plan::summary).collect::<Vec<_>>().join(", "),
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
