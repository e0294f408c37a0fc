//! Outputs on disk: compared first, then written whole or not at all.
//!
//! devc writes the outputs into the folder `<out>/<id>`, or a folder there, and nothing else, and replaces only what it made itself. New files
//! go to drafts in the output folder; once all are there, they are renamed, so that a full disk leaves the old outputs as
//! they were.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use devc::emit::Files;

use super::draft::Draft;
use super::existing;
use super::names::{portable, portable_path};
use super::outcome::Failure;
use super::report::number;
use super::sums::{self, Sums};
use super::workplace::{self, Workplace};

/// What has to be done so that a device's folder holds its outputs.
#[derive(Debug)]
pub(super) struct Plan<'a> {
    out: &'a Path,
    folder: PathBuf,
    sums: Sums,
    changes: BTreeMap<String, Change<'a>>,
    unchanged: usize,
}

#[derive(Debug)]
enum Change<'a> {
    /// There is no such file yet.
    Create(&'a [u8]),
    /// The file says something else from this line on.
    Replace(&'a [u8], usize),
}

impl<'a> Plan<'a> {
    /// Compares a device's outputs with what lies in its folder.
    pub(super) fn new(out: &'a Path, id: &str, files: &'a mut Files) -> Result<Self, Failure> {
        let folder = out.join(portable(id)?);
        let mut plan = Plan { out, folder, sums: Sums::default(), changes: BTreeMap::new(), unchanged: 0 };
        plan.stay_inside(files.0.keys())?;
        plan.sums = Sums::read(&plan.folder, id)?;
        plan.sums.add(files, id);
        for (name, bytes) in &files.0 {
            match plan.compare(portable_path(name)?, bytes)? {
                None => plan.unchanged += 1,
                Some(change) => _ = plan.changes.insert(name.to_owned(), change),
            }
        }
        Ok(plan)
    }

    /// The output folder.
    pub(super) fn out(&self) -> &Path {
        self.out
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
            }
        })
    }

    /// What was done, in a line.
    pub(super) fn summary(&self) -> String {
        let names: Vec<&str> = self.changes.keys().map(String::as_str).collect();
        let mut parts = Vec::new();
        if !names.is_empty() {
            parts.push(format!("wrote {} to {}", names.join(", "), self.folder.display()));
        }
        if self.unchanged > 0 || names.is_empty() {
            parts.push(format!("{} up to date", number(self.unchanged, "file")));
        }
        parts.join(", ")
    }

    /// Brings the folder up to date.
    pub(super) fn carry_out(&self, place: &Workplace) -> Result<(), Failure> {
        let mut drafts = Vec::new();
        for (name, Change::Create(bytes) | Change::Replace(bytes, _)) in &self.changes {
            drafts.push((Draft::write(place, &self.folder.join(name), bytes)?, name, bytes));
        }
        // the sums last: up to then the old ones answer for the old files
        drafts.sort_by_key(|(_, name, _)| sums::are_in(name));
        for folder in self.folders(self.changes.keys()) {
            make_folder(&folder)?;
        }
        self.stay_inside(self.changes.keys())?;
        for (draft, name, bytes) in drafts {
            // Somebody may have put a file of theirs there meanwhile.
            self.compare(name, bytes)?;
            draft.publish()?;
        }
        Ok(())
    }

    /// What has to be done so that the file has these bytes, if anything; only what devc made may be replaced.
    fn compare<'t>(&self, name: &str, bytes: &'t [u8]) -> Result<Option<Change<'t>>, Failure> {
        let path = &self.folder.join(name);
        match existing::read(path, bytes.len().saturating_add(1))? {
            None => Ok(Some(Change::Create(bytes))),
            Some(old) if old == bytes => Ok(None),
            Some(old) if existing::is_made_by_devc(&old) || self.sums.has(name, &old) => {
                existing::be_writable(path)?;
                Ok(Some(Change::Replace(bytes, first_difference(&old, bytes))))
            }
            Some(_) => {
                let what = format!("`{}` was not made by devc, so it is not replaced", path.display());
                Err(Failure::new(what).help("move it away, or name another folder with `--out`"))
            }
        }
    }

    /// The folders of these files.
    fn folders<'n>(&self, names: impl Iterator<Item = &'n String>) -> BTreeSet<PathBuf> {
        names.map(|name| workplace::folder(&self.folder.join(name)).to_owned()).collect()
    }

    /// Sees to it that no link leads from a folder of these files out of the output folder.
    fn stay_inside<'n>(&self, names: impl Iterator<Item = &'n String>) -> Result<(), Failure> {
        self.folders(names).iter().chain([&self.folder]).try_for_each(|folder| self.is_inside(folder))
    }

    fn is_inside(&self, folder: &Path) -> Result<(), Failure> {
        let failure = |path: &Path, error: &io::Error| Failure::at("look into", path, error);
        let found = match fs::canonicalize(folder) {
            Ok(found) => found,
            // A link to where nothing is: it will be found when the folder is made.
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(()),
            Err(error) => return Err(failure(folder, &error)),
        };
        if found.starts_with(fs::canonicalize(self.out).map_err(|error| failure(self.out, &error))?) {
            return Ok(());
        }
        let what = format!("`{}` is a link that leads out of `{}`", folder.display(), self.out.display());
        Err(Failure::new(what).help("remove the link, or name the folder it leads to with `--out`"))
    }
}

/// Makes a folder where there is none.
pub(super) fn make_folder(folder: &Path) -> Result<(), Failure> {
    if fs::metadata(folder).is_ok_and(|metadata| !metadata.is_dir()) {
        return Err(Failure::new(format!("`{}` is not a folder", folder.display()))
            .help("move it away, or name another folder with `--out`"));
    }
    fs::create_dir_all(folder).map_err(|error| Failure::at("make the folder", folder, &error))
}

/// The line from which on two texts differ, counted from 1.
fn first_difference(old: &[u8], new: &[u8]) -> usize {
    let same = old.iter().zip(new).take_while(|(old, new)| old == new);
    1 + same.filter(|(byte, _)| **byte == b'\n').count()
}
