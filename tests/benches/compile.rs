//! `devc build` as people run it: whole processes from start to files written.
//!
//! `cargo bench -p devc-tests --bench compile [-- ROUNDS]`. In every round each process runs once, one after the
//! other, so that what else the machine does meets all of them; what is compared is the ratio within a round.
//!
//! - *nothing*: a process that ends as soon as it has started;
//! - *plain*: a process that parses the same files with `toml` into `serde_json::Value`, checks nothing, and writes
//!   the same bytes to as many files;
//! - *devc*: `devc build` with its checks and all of its outputs.
#![allow(clippy::print_stdout, reason = "a benchmark is there to print")]

mod measure;

use std::ffi::OsString;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};
use std::{env, fs};

use measure::{Fallible, instructions, run};

const ROUNDS: usize = 21;

fn main() -> Fallible<()> {
    let arguments: Vec<OsString> = env::args_os().skip(1).filter(|argument| argument != "--bench").collect();
    match arguments.iter().map(|argument| argument.to_str()).collect::<Vec<_>>()[..] {
        [Some("nothing")] => Ok(()),
        [Some("plain"), Some(outputs), Some(target), ..] => {
            plain(Path::new(outputs), Path::new(target), arguments.get(3..).unwrap_or_default())
        }
        [Some(rounds)] => bench(rounds.parse()?),
        _ => bench(ROUNDS),
    }
}

/// What a program does at the least that reads these descriptions and writes these outputs.
fn plain(outputs: &Path, target: &Path, descriptions: &[OsString]) -> Fallible<()> {
    for description in descriptions.iter().map(Path::new) {
        for file in files(description)?.iter().filter(|file| file.extension().is_some_and(|it| it == "toml"))
        {
            let value: serde_json::Value = toml::from_str(&fs::read_to_string(file)?)?;
            black_box(value);
        }
        let name = description.file_name().unwrap_or_default();
        fs::create_dir_all(target.join(name))?;
        for file in files(&outputs.join(name))? {
            fs::write(target.join(name).join(file.file_name().unwrap_or_default()), fs::read(&file)?)?;
        }
    }
    Ok(())
}

fn files(folder: &Path) -> Fallible<Vec<PathBuf>> {
    let mut files = fs::read_dir(folder)?.map(|file| Ok(file?.path())).collect::<Fallible<Vec<_>>>()?;
    files.sort();
    Ok(files)
}

/// A process to measure; it writes to the folder it is given.
struct Subject {
    name: &'static str,
    command: Box<dyn Fn(&Path) -> Command>,
    times: Vec<Duration>,
}

impl Subject {
    fn new(name: &'static str, command: impl Fn(&Path) -> Command + 'static) -> Self {
        Self { name, command: Box::new(command), times: Vec::new() }
    }

    /// Runs once, into an empty folder.
    fn round(&mut self) -> Fallible<()> {
        let folder = tempfile::tempdir()?;
        self.times.push(wall(&mut (self.command)(folder.path()))?);
        Ok(())
    }

    /// The median of the ratios to what another process took in the same round.
    fn ratio(&self, other: &Self) -> f64 {
        let pairs = self.times.iter().zip(&other.times);
        median(pairs.map(|(own, other)| own.as_secs_f64() / other.as_secs_f64()).collect())
    }

    fn instructions(&self) -> Fallible<Option<u64>> {
        let folder = tempfile::tempdir()?;
        Ok(instructions(&(self.command)(folder.path()), None)?.map(|parts| parts.iter().sum()))
    }
}

fn bench(rounds: usize) -> Fallible<()> {
    let devc = devc()?;
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let shipped = files(&root.join("devices"))?;
    let c887: Vec<PathBuf> = shipped.iter().filter(|path| path.ends_with("c887")).cloned().collect();
    let outputs = tempfile::tempdir()?;
    let build = |paths: &[PathBuf]| {
        let (devc, paths) = (devc.clone(), paths.to_vec());
        move |out: &Path| {
            let mut command = Command::new(&devc);
            command.arg("build").args(&paths).arg("--out").arg(out);
            command
        }
    };
    let timings = run(build(&shipped)(outputs.path()).arg("--timings"))?;
    let mut subjects = subjects(outputs.path(), &c887, &shipped, build)?;
    for _ in 0..rounds {
        subjects.iter_mut().try_for_each(Subject::round)?;
    }
    print(&subjects)?;
    println!("\nthe stages of one run:\n{}", String::from_utf8_lossy(&timings.stderr).trim_end());
    Ok(())
}

/// In the order in which they are printed: nothing, then plain and devc for one description and for all.
fn subjects<F: Fn(&Path) -> Command + 'static>(
    outputs: &Path,
    one: &[PathBuf],
    all: &[PathBuf],
    build: impl Fn(&[PathBuf]) -> F,
) -> Fallible<[Subject; 5]> {
    let own = env::current_exe()?;
    let plain = |paths: &[PathBuf]| {
        let (own, outputs, paths) = (own.clone(), outputs.to_owned(), paths.to_vec());
        move |target: &Path| {
            let mut command = Command::new(&own);
            command.arg("plain").arg(&outputs).arg(target).args(&paths);
            command
        }
    };
    let nothing = own.clone();
    Ok([
        Subject::new("nothing", move |_| {
            let mut command = Command::new(&nothing);
            command.arg("nothing");
            command
        }),
        Subject::new("plain, c887", plain(one)),
        Subject::new("devc, c887", build(one)),
        Subject::new("plain, all", plain(all)),
        Subject::new("devc, all", build(all)),
    ])
}

fn print(subjects: &[Subject; 5]) -> Fallible<()> {
    let [nothing, plain_one, _, plain_all, _] = subjects;
    println!("{:<14}{:>10}{:>14}{:>12}{:>16}", "process", "median", "of nothing", "of plain", "instructions");
    for (subject, plain) in subjects.iter().zip([nothing, plain_one, plain_one, plain_all, plain_all]) {
        let times = subject.times.iter().map(|time| ms(*time)).collect();
        let count = match subject.instructions()? {
            Some(count) => format!("{:.1} M", count as f64 / 1e6),
            None => "no valgrind".to_owned(),
        };
        let (floor, ratio) = (subject.ratio(nothing), subject.ratio(plain));
        println!("{:<14}{:>7.2} ms{floor:>13.1}x{ratio:>11.2}x{count:>16}", subject.name, median(times));
    }
    Ok(())
}

/// The command line in release, built if it is not up to date, beside the folder of this benchmark's own program.
fn devc() -> Fallible<PathBuf> {
    run(Command::new(env!("CARGO")).args(["build", "--release", "--package", "devc", "--bin", "devc"]))?;
    let own = env::current_exe()?;
    let folder = own.parent().and_then(Path::parent).ok_or("the benchmark lies in no target folder")?;
    Ok(folder.join("devc").with_extension(env::consts::EXE_EXTENSION))
}

/// From the start of a process to its end.
fn wall(command: &mut Command) -> Fallible<Duration> {
    let start = Instant::now();
    run(command)?;
    Ok(start.elapsed())
}

/// The middle one.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Milliseconds.
fn ms(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
