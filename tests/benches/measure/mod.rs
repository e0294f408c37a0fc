//! What whole processes cost in instructions, which do not depend on what else the machine does.

use std::error::Error;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;
use std::process::{Command, Output};

/// What can go wrong with a measurement.
pub(crate) type Fallible<T> = Result<T, Box<dyn Error>>;

/// Runs a process to its end, which has to be a good one.
pub(crate) fn run(command: &mut Command) -> Fallible<Output> {
    let output = command.output()?;
    if output.status.success() {
        return Ok(output);
    }
    Err(format!("{command:?}: {}\n{}", output.status, String::from_utf8_lossy(&output.stderr)).into())
}

/// The instructions of a process, in parts that end whenever it enters the function `ends`; none without valgrind.
pub(crate) fn instructions(command: &Command, ends: Option<&str>) -> Fallible<Option<Vec<u64>>> {
    let folder = tempfile::tempdir()?;
    let mut valgrind = Command::new("valgrind");
    valgrind.args(["--tool=callgrind", "--quiet"]);
    valgrind.arg(format!("--callgrind-out-file={}", folder.path().join("out").display()));
    valgrind.args(ends.map(|ends| format!("--dump-before=*{ends}*")));
    valgrind.arg(command.get_program()).args(command.get_args());
    valgrind.envs(command.get_envs().filter_map(|(name, value)| Some((name, value?))));
    match run(&mut valgrind) {
        Ok(_) => Ok(Some(parts(folder.path())?)),
        Err(error) if error.downcast_ref().is_some_and(is_missing) => Ok(None),
        Err(error) => Err(error),
    }
}

fn is_missing(error: &std::io::Error) -> bool {
    error.kind() == ErrorKind::NotFound
}

/// The sums in callgrind's files: `out.1`, `out.2` and so on, and `out` for what is left at the end.
fn parts(folder: &Path) -> Fallible<Vec<u64>> {
    let numbered = (1..).map(|part| folder.join(format!("out.{part}"))).take_while(|path| path.exists());
    let mut sums = Vec::new();
    for path in numbered.chain([folder.join("out")]).filter(|path| path.exists()) {
        let text = fs::read_to_string(&path)?;
        let sum = text.lines().rev().find_map(|line| line.strip_prefix("totals: "));
        sums.push(sum.ok_or_else(|| format!("{} has no sum", path.display()))?.trim().parse()?);
    }
    Ok(sums)
}
