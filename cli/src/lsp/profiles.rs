//! Profiles as files, since editors show nothing else.

use std::fs;
use std::path::PathBuf;

/// A folder of this run with the profiles that were asked for, to be read only; gone at the end.
#[derive(Debug, Default)]
pub(super) struct Profiles {
    folder: Option<PathBuf>,
}

impl Profiles {
    /// The file with the text of a profile; none if the system lets none be written.
    pub(super) fn file(&mut self, name: &str, text: &str) -> Option<PathBuf> {
        let path = self.folder()?.join(format!("{name}.toml"));
        if !path.exists() {
            fs::write(&path, text).ok()?;
            let mut rights = fs::metadata(&path).ok()?.permissions();
            rights.set_readonly(true);
            fs::set_permissions(&path, rights).ok()?;
        }
        Some(path)
    }

    /// Whether a file is one of them.
    pub(super) fn has(&self, path: &std::path::Path) -> bool {
        self.folder.as_ref().is_some_and(|folder| path.starts_with(folder))
    }

    fn folder(&mut self) -> Option<PathBuf> {
        if self.folder.is_none() {
            let base = std::env::temp_dir();
            let names =
                (0..100).map(|number| base.join(format!("devc-profiles-{}-{number}", std::process::id())));
            // a folder that is there already may be another's
            let made = names.into_iter().find(|folder| fs::create_dir(folder).is_ok())?;
            self.folder = Some(fs::canonicalize(&made).unwrap_or(made));
        }
        self.folder.clone()
    }
}

impl Drop for Profiles {
    fn drop(&mut self) {
        if let Some(folder) = &self.folder {
            let _ = fs::remove_dir_all(folder);
        }
    }
}
