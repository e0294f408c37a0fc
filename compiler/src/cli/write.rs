//! Outputs on disk: compared first, then written whole or not at all.
//!
//! devc owns the files `<out>/<id>/<id>.*` and nothing else. New texts go to temporary files beside their
//! targets; once all are there, they are renamed, so that a full disk leaves the old outputs as they were.

use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;
use std::path::{Component, Path, PathBuf};

use devc::emit::Files;

use super::draft::{Draft, TEMPORARY};
use super::outcome::Failure;
use super::report::number;

/// Whether the files are all that there is for a device.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Scope {
    /// All: other files of the device are stale.
    All,
    /// Only some outputs were asked for: the others stay.
    Some,
}

/// What has to be done so that a device's folder holds its outputs.
#[derive(Debug)]
pub(super) struct Plan<'a> {
    out: &'a Path,
    folder: PathBuf,
    changes: BTreeMap<String, Change<'a>>,
    leftovers: Vec<PathBuf>,
    unchanged: usize,
}

#[derive(Debug)]
enum Change<'a> {
    /// There is no such file yet.
    Create(&'a str),
    /// The file says something else from this line on.
    Replace(&'a str, usize),
    /// devc does not make the file any more.
    Remove,
}

impl<'a> Plan<'a> {
    /// Compares a device's outputs with what lies in its folder.
    pub(super) fn new(out: &'a Path, id: &str, files: &'a Files, scope: Scope) -> Result<Self, Failure> {
        let folder = out.join(name_of_one_folder(id)?);
        let mut plan = Plan { out, folder, changes: BTreeMap::new(), leftovers: Vec::new(), unchanged: 0 };
        for (path, text) in &files.0 {
            let name = path.strip_prefix(id).and_then(|rest| rest.strip_prefix('/')).unwrap_or(path);
            plan.compare(name_of_one_folder(name)?, text)?;
        }
        plan.look_around(id, files, scope)?;
        Ok(plan)
    }

    fn compare(&mut self, name: &str, text: &'a str) -> Result<(), Failure> {
        let path = self.folder.join(name);
        let change = match fs::read(&path) {
            Ok(old) if old == text.as_bytes() => {
                self.unchanged += 1;
                return Ok(());
            }
            Ok(old) => Change::Replace(text, first_difference(&old, text.as_bytes())),
            Err(error) if error.kind() == ErrorKind::NotFound => Change::Create(text),
            Err(error) => return Err(Failure::at("read", &path, &error)),
        };
        self.changes.insert(name.to_owned(), change);
        Ok(())
    }

    /// Finds files of the device that devc no longer makes, and those that a killed run left behind.
    fn look_around(&mut self, id: &str, files: &Files, scope: Scope) -> Result<(), Failure> {
        let entries = match fs::read_dir(&self.folder) {
            Ok(entries) => entries,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(()),
            Err(error) => return Err(Failure::at("look into", &self.folder, &error)),
        };
        for entry in entries {
            let entry = entry.map_err(|error| Failure::at("look into", &self.folder, &error))?;
            let name = entry.file_name().to_string_lossy().into_owned();
            let ours = name.strip_prefix(id).is_some_and(|rest| rest.starts_with('.'));
            if name.starts_with(&format!(".{id}.")) && name.ends_with(TEMPORARY) {
                self.leftovers.push(entry.path());
            } else if scope == Scope::All
                && ours
                && !files.0.contains_key(&format!("{id}/{name}"))
                && entry.file_type().is_ok_and(|kind| kind.is_file())
            {
                self.changes.insert(name, Change::Remove);
            }
        }
        Ok(())
    }

    /// Whether the folder is as it should be.
    pub(super) fn is_empty(&self) -> bool {
        self.changes.is_empty()
    }

    /// What is not as it should be, a sentence a file.
    pub(super) fn differences(&self) -> impl Iterator<Item = String> {
        self.changes.iter().map(|(name, change)| {
            let path = self.folder.join(name);
            let path = path.display();
            match change {
                Change::Create(_) => format!("`{path}` is missing"),
                Change::Replace(_, line) => {
                    format!("`{path}` differs from what its description gives, from line {line} on")
                }
                Change::Remove => format!("`{path}` is stale: devc does not make it any more"),
            }
        })
    }

    /// What was done, in a line.
    pub(super) fn summary(&self) -> String {
        let names = |wanted: fn(&Change<'_>) -> bool| {
            let names =
                self.changes.iter().filter(|(_, change)| wanted(change)).map(|(name, _)| name.as_str());
            names.collect::<Vec<_>>().join(", ")
        };
        let written = names(|change| !matches!(change, Change::Remove));
        let removed = names(|change| matches!(change, Change::Remove));
        let mut parts = Vec::new();
        if !written.is_empty() {
            parts.push(format!("wrote {written} to {}", self.folder.display()));
        }
        if !removed.is_empty() {
            parts.push(format!("removed {removed}"));
        }
        if self.unchanged > 0 || parts.is_empty() {
            parts.push(format!("{} up to date", number(self.unchanged, "file")));
        }
        parts.join(", ")
    }

    /// Brings the folder up to date.
    pub(super) fn carry_out(&self) -> Result<(), Failure> {
        if self.changes.is_empty() && self.leftovers.is_empty() {
            return Ok(());
        }
        self.make_folder()?;
        for path in &self.leftovers {
            fs::remove_file(path).map_err(|error| Failure::at("remove", path, &error))?;
        }
        let mut drafts = Vec::new();
        for (name, change) in &self.changes {
            if let Change::Create(text) | Change::Replace(text, _) = change {
                drafts.push(Draft::write(&self.folder, name, text)?);
            }
        }
        drafts.into_iter().try_for_each(Draft::publish)?;
        for (name, _) in self.changes.iter().filter(|(_, change)| matches!(change, Change::Remove)) {
            let path = self.folder.join(name);
            fs::remove_file(&path).map_err(|error| Failure::at("remove", &path, &error))?;
        }
        Ok(())
    }

    /// Makes the folder, and sees to it that no link in it leads out of the output folder.
    fn make_folder(&self) -> Result<(), Failure> {
        fs::create_dir_all(&self.folder)
            .map_err(|error| Failure::at("make the folder", &self.folder, &error))?;
        let canonical =
            |path: &Path| fs::canonicalize(path).map_err(|error| Failure::at("look into", path, &error));
        if !canonical(&self.folder)?.starts_with(canonical(self.out)?) {
            let (folder, out) = (self.folder.display(), self.out.display());
            return Err(Failure::new(format!("`{folder}` is a link that leads out of `{out}`")));
        }
        Ok(())
    }
}

/// The name, if it is one: not a path, and no way out of the folder.
fn name_of_one_folder(name: &str) -> Result<&str, Failure> {
    let mut parts = Path::new(name).components();
    match (parts.next(), parts.next()) {
        (Some(Component::Normal(part)), None) if part == name => Ok(name),
        _ => Err(Failure::new(format!("`{name}` cannot be the name of an output"))),
    }
}

/// The line from which on two texts differ, counted from 1.
fn first_difference(old: &[u8], new: &[u8]) -> usize {
    let same = old.iter().zip(new).take_while(|(old, new)| old == new);
    1 + same.filter(|(byte, _)| **byte == b'\n').count()
}
