//! `devc import`

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;
use devc::format::format;
use devc::import::{Choice, Imported, Refusal, earlier, import};
use devc::source::{MAX_SIZE, plain};

use super::draft::Draft;
use super::existing;
use super::outcome::{Failure, Outcome};
use super::report::Report;
use super::workplace::{Workplace, folder};

/// Make a description of an ESI file, of an EDS, or of what `ethercat sdos` prints.
///
/// What the description cannot say is reported on the standard error, and what had to be guessed, each with its place in
/// the file.
#[derive(Debug, Args)]
pub(super) struct Import {
    /// The ESI file (XML), the EDS (CiA 306), or the list that `ethercat sdos` of IgH's master prints.
    #[arg(value_name = "FILE")]
    file: PathBuf,

    /// The device, where the file has several: its number in the file, its type or its name.
    #[arg(long, value_name = "N|NAME")]
    device: Option<String>,

    /// The revision of the device [default: the newest].
    #[arg(long, value_name = "R", value_parser = revision)]
    revision: Option<u32>,

    /// The folder of the description [default: a folder in `devices` with the name of the device].
    #[arg(long, short, value_name = "DIR")]
    out: Option<PathBuf>,

    /// Write over the files of an earlier import.
    #[arg(long)]
    overwrite: bool,

    /// Write what was kept, lost and guessed to a file, as JSON.
    #[arg(long, value_name = "FILE.json")]
    report: Option<PathBuf>,
}

/// A revision in decimal or, after `0x` or `#x`, in hexadecimal.
fn revision(text: &str) -> Result<u32, String> {
    let hex = text.strip_prefix("0x").or_else(|| text.strip_prefix("#x"));
    let number = hex.map_or_else(|| text.parse().ok(), |digits| u32::from_str_radix(digits, 16).ok());
    number.ok_or_else(|| "expected a number such as 0x00010002".to_owned())
}

impl Import {
    pub(super) fn run(&self, report: &Report) -> Result<Outcome, Failure> {
        let choice = Choice { device: self.device.clone(), revision: self.revision };
        let imported = imported(&self.file, None, &choice)?;
        let out = self.out.clone().unwrap_or_else(|| Path::new("devices").join(&imported.id));
        let file = self.file.display().to_string();
        let losses = self.report.as_ref().map(|path| (path, imported.report.json(&file)));
        let laid_out = imported
            .files
            .iter()
            .map(|(name, text)| (out.join(name), format(name, text).unwrap_or_else(|_| text.clone())));
        let laid_out: Vec<(PathBuf, String)> = laid_out.collect();
        let files = laid_out.iter().map(|(path, text)| (path.clone(), text.as_bytes()));
        let pictures = imported.pictures.iter().map(|(name, bytes)| (out.join(name), bytes.as_slice()));
        let losses = losses.iter().map(|(path, text)| ((*path).clone(), text.as_bytes()));
        let outdated = if self.overwrite { outdated(&out, &imported)? } else { Vec::new() };
        self.write(&files.chain(pictures).chain(losses).collect::<Vec<_>>(), report)?;
        for path in outdated {
            fs::remove_file(&path).map_err(|error| Failure::at("remove", &path, &error))?;
            report.line(&format!("{}: removed, since this import has no such file", path.display()));
        }
        report.message(imported.report.text(&file).trim_end());
        let names = imported.files.keys().chain(imported.pictures.keys());
        let names: Vec<&str> = names.map(String::as_str).collect();
        report.line(&format!("{}: wrote {}", out.display(), names.join(", ")));
        Ok(Outcome::Clean)
    }

    /// Writes all files, or none if one of them is there already.
    fn write(&self, files: &[(PathBuf, &[u8])], report: &Report) -> Result<(), Failure> {
        let mut drafts = Vec::new();
        // Each folder is entered once: who is in it keeps others out.
        let mut places: BTreeMap<PathBuf, Workplace> = BTreeMap::new();
        for (path, text) in files {
            if existing::read(path, 0)?.is_some() {
                self.may_replace(path)?;
            }
            let folder = folder(path);
            let made = fs::create_dir_all(folder).and_then(|()| fs::canonicalize(folder));
            let folder = made.map_err(|error| Failure::at("make the folder", folder, &error))?;
            let place = places.entry(folder).or_insert_with_key(|folder| Workplace::enter(folder, report));
            drafts.push(Draft::write(place, path, text)?);
        }
        drafts.into_iter().try_for_each(Draft::publish)
    }

    fn may_replace(&self, path: &Path) -> Result<(), Failure> {
        if self.overwrite {
            return existing::be_writable(path);
        }
        let failure = Failure::new(format!("`{}` is there already", path.display()));
        Err(failure.help("give another folder by `--out`, or say `--overwrite`"))
    }
}

/// The files of an earlier import that the new one has not: those that begin as that import wrote them.
fn outdated(out: &Path, imported: &Imported) -> Result<Vec<PathBuf>, Failure> {
    let Some(device) = existing::read(&out.join("device.toml"), MAX_SIZE)? else { return Ok(Vec::new()) };
    let mut outdated = Vec::new();
    for (name, beginning) in earlier(&String::from_utf8_lossy(&device)) {
        let path = out.join(name);
        let is_new = imported.files.contains_key(name);
        if !is_new && existing::read(&path, 0)?.is_some_and(|it| it.starts_with(beginning.as_bytes())) {
            existing::be_writable(&path)?;
            outdated.push(path);
        }
    }
    Ok(outdated)
}

/// The description of a device of an ESI file, which says that its facts are from the file, or from what it is `called`:
/// two versions of one file have the same source.
pub(super) fn imported(file: &Path, called: Option<&str>, choice: &Choice) -> Result<Imported, Failure> {
    let limit = u64::try_from(MAX_SIZE).unwrap_or(u64::MAX).saturating_add(1);
    let bytes = plain::read(file, limit).map_err(|error| Failure::at("read", file, &error))?;
    let name = file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    import(&bytes, called.unwrap_or(&name), choice).map_err(|refusal| refused(file, &refusal))
}

fn refused(file: &Path, refusal: &Refusal) -> Failure {
    let place = refusal.place.map(|(line, column)| format!(":{line}:{column}")).unwrap_or_default();
    let failure = Failure::new(format!("cannot import `{}{place}`: {}", file.display(), refusal.why));
    match refusal.choices.as_slice() {
        [] => failure,
        choices => failure
            .choices(choices)
            .help("choose one of these with `--device` and `--revision` of `devc import`"),
    }
}
