//! A folder to which one devc writes at a time.

use std::fs::{self, File, TryLockError};
use std::path::{Path, PathBuf};

use devc::text::characters::line;

use super::report::Report;

/// How the names of files begin that are being written; two numbers follow. What else has such a name was left by a run
/// that was killed.
pub(super) const DRAFT: &str = ".devc-draft-";

/// A folder for drafts, held until this is dropped or the process ends.
///
/// The folder itself is locked, so that nothing is left behind. Where the system cannot lock folders, as Windows and
/// some networks, two runs may write at once: each file is whole all the same.
pub(super) struct Workplace {
    pub(super) folder: PathBuf,
    lock: Option<File>,
}

impl Workplace {
    /// Waits until no other devc writes to the folder, and clears away what those that were killed have left.
    pub(super) fn enter(folder: &Path, report: &Report) -> Self {
        let workplace = Self { folder: folder.to_owned(), lock: lock(folder, report) };
        if workplace.lock.is_some() {
            workplace.clear();
        }
        workplace
    }

    /// The folder of a file that this run alone writes: it is not held, so that others need not wait until the run ends.
    pub(super) fn of(file: &Path) -> Self {
        Self { folder: folder(file).to_owned(), lock: None }
    }

    /// What cannot be removed does no harm.
    fn clear(&self) {
        for entry in fs::read_dir(&self.folder).into_iter().flatten().flatten() {
            if is_draft(&entry.file_name().to_string_lossy())
                && entry.file_type().is_ok_and(|kind| kind.is_file())
            {
                let _ = fs::remove_file(entry.path());
            }
        }
    }
}

/// The folder that a file is in.
pub(super) fn folder(file: &Path) -> &Path {
    file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Whether this is the name of a draft, `.devc-draft-<process>-<number>`, and not merely one that begins like it.
fn is_draft(name: &str) -> bool {
    let is_number = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    let numbers = name.strip_prefix(DRAFT).and_then(|rest| rest.split_once('-'));
    numbers.is_some_and(|(process, number)| is_number(process) && is_number(number))
}

fn lock(folder: &Path, report: &Report) -> Option<File> {
    let file = File::open(folder).ok()?;
    match file.try_lock() {
        Ok(()) => Some(file),
        Err(TryLockError::Error(_)) => None,
        Err(TryLockError::WouldBlock) => {
            report.message(&line(&format!("waiting for another devc that writes to `{}`", folder.display())));
            file.lock().is_ok().then_some(file)
        }
    }
}
