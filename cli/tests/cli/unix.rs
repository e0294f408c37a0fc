//! What only systems like Unix have: modes, links, pipes, other users.

use std::fs;
use std::os::unix::fs::{MetadataExt, PermissionsExt, lchown, symlink};
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::{Desk, Run};

/// A user who owns nothing.
const NOBODY: u32 = 65534;

impl Desk {
    /// Makes a symbolic link.
    pub(crate) fn link(&self, target: &str, name: &str) {
        symlink(target, self.path(name)).expect("a link");
    }

    /// Makes a pipe that nobody writes to.
    pub(crate) fn pipe(&self, name: &str) {
        let status = Command::new("mkfifo").arg(self.path(name)).status().expect("mkfifo");
        assert!(status.success());
    }

    pub(crate) fn mode(&self, path: &str) -> u32 {
        fs::metadata(self.path(path)).expect("a file").mode() & 0o777
    }

    pub(crate) fn set_mode(&self, path: &str, mode: u32) {
        fs::set_permissions(self.path(path), fs::Permissions::from_mode(mode)).expect("a mode");
    }

    /// Runs devc as a user whom modes hold back: if need be as nobody, to whom the folder is given. None if nobody may
    /// not run it.
    pub(crate) fn as_nobody(&self, arguments: &[&str]) -> Option<Run> {
        if !is_superuser() {
            return Some(self.devc(arguments));
        }
        give(self.folder.path(), NOBODY);
        let mut command = self.command(arguments);
        let command = command.uid(NOBODY).gid(NOBODY).stdin(Stdio::null());
        let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
        child.ok().map(Run::of)
    }
}

/// Whether modes and owners are nothing to the user who runs the tests.
pub(crate) fn is_superuser() -> bool {
    tempfile::tempfile().and_then(|file| file.metadata()).is_ok_and(|metadata| metadata.uid() == 0)
}

/// Gives a folder to another user, with all that is in it.
fn give(path: &Path, user: u32) {
    lchown(path, Some(user), Some(user)).expect("an owner");
    if fs::symlink_metadata(path).is_ok_and(|metadata| metadata.is_dir()) {
        let entries = fs::read_dir(path).expect("a folder");
        entries.for_each(|entry| give(&entry.expect("an entry").path(), user));
    }
}

/// Says why a test is not run here.
#[expect(clippy::print_stderr, reason = "for whoever reads what a test says")]
pub(crate) fn skipped(why: &str) {
    eprintln!("skipped: {why}");
}
