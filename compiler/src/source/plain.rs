//! Plain files of the machine: what was opened is looked at, not what a path led to a moment before.

#[cfg(target_os = "linux")]
use std::os::fd::AsRawFd;
#[cfg(unix)]
use std::os::unix::fs::MetadataExt;
#[cfg(all(unix, feature = "cli"))]
use std::os::unix::fs::OpenOptionsExt;

use std::fs::{self, File, Metadata};
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};

/// The bytes of a plain file, at most `limit`; links are followed.
///
/// # Errors
/// If there is no such file, or it cannot be read, or it is a folder, a pipe or a device.
pub fn read(path: &Path, limit: u64) -> io::Result<Vec<u8>> {
    content(&open(path)?, limit)
}

/// Opens a plain file; a pipe is refused, not waited for.
pub(super) fn open(path: &Path) -> io::Result<File> {
    // Before, because opening a device may set something off; and after, because it may be another by then.
    be_plain(&fs::metadata(path)?)?;
    let mut options = File::options();
    options.read(true);
    // A build has nothing to fear but a pipe put there in this moment, and is not worth a dependency for that.
    #[cfg(all(unix, feature = "cli"))]
    options.custom_flags(libc::O_NONBLOCK);
    let file = options.open(path)?;
    be_plain(&file.metadata()?)?;
    Ok(file)
}

/// The bytes of an opened file, at most `limit`.
pub(super) fn content(file: &File, limit: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    file.take(limit).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// The one name of a file that was opened by `path`, with links followed; none if it has been replaced since.
pub(super) fn name(file: &File, path: &Path) -> io::Result<Option<PathBuf>> {
    #[cfg(target_os = "linux")]
    if let Ok(name) = fs::read_link(format!("/proc/self/fd/{}", file.as_raw_fd())) {
        // To the name of a file that has none any more the system adds ` (deleted)`.
        return Ok(fs::symlink_metadata(&name).is_ok().then_some(name));
    }
    let name = fs::canonicalize(path)?;
    Ok(are_same(&file.metadata()?, &fs::symlink_metadata(&name)?).then_some(name))
}

#[cfg(unix)]
fn are_same(one: &Metadata, other: &Metadata) -> bool {
    (one.dev(), one.ino()) == (other.dev(), other.ino())
}

#[cfg(not(unix))]
fn are_same(_: &Metadata, _: &Metadata) -> bool {
    true
}

fn be_plain(metadata: &Metadata) -> io::Result<()> {
    if metadata.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    if !metadata.is_file() {
        return Err(io::Error::new(ErrorKind::InvalidInput, "it is no plain file"));
    }
    Ok(())
}
