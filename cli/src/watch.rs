//! Doing something again whenever files change.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::thread::sleep;
use std::time::{Duration, SystemTime};

use super::outcome::{Failure, Outcome};
use super::report::{Report, number};

/// How often the files are looked at.
const PAUSE: Duration = Duration::from_millis(200);

/// What is seen of a file from outside; none if it is not there.
type Seen = Option<(SystemTime, u64)>;

/// Does the work, which tells the files that it depends on, and again after each change of them, until nobody reads
/// what is said any more.
pub(super) fn watch(
    report: &Report,
    work: impl Fn() -> Result<(Outcome, Vec<PathBuf>), Failure>,
) -> Result<Outcome, Failure> {
    let (mut outcome, mut files) = work()?;
    // what changes while the work is done is noticed, since the files are looked at from before it
    let mut before = look(&files);
    report.line(&format!("watching {}; stop it with Ctrl-C", number(files.len(), "path")));
    while !report.is_lost() {
        sleep(PAUSE);
        let now = look(&files);
        if now == before {
            continue;
        }
        // an editor may still be writing
        let settled = settle(&files, now);
        match work() {
            Ok(done) => (outcome, files) = done,
            Err(failure) => outcome = report.failure(&failure),
        }
        let same: BTreeMap<PathBuf, Seen> =
            settled.into_iter().filter(|(file, _)| files.contains(file)).collect();
        let new = look(&files).into_iter().filter(|(file, _)| !same.contains_key(file)).collect::<Vec<_>>();
        before = same.into_iter().chain(new).collect();
    }
    Ok(outcome)
}

/// Waits until the files stay as they are.
fn settle(files: &[PathBuf], mut seen: BTreeMap<PathBuf, Seen>) -> BTreeMap<PathBuf, Seen> {
    loop {
        sleep(PAUSE / 4);
        let now = look(files);
        if now == seen {
            return now;
        }
        seen = now;
    }
}

fn look(files: &[PathBuf]) -> BTreeMap<PathBuf, Seen> {
    let seen = |file: &PathBuf| {
        let metadata = fs::metadata(file).ok()?;
        Some((metadata.modified().ok()?, metadata.len()))
    };
    files.iter().map(|file| (file.clone(), seen(file))).collect()
}
