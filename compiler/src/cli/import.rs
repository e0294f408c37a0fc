//! `devc import`

use std::fs::{self, File};
use std::io::{ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

use clap::Args;
use devc::import::{Choice, Imported, import};
use devc::source::MAX_SIZE;

use super::outcome::{Failure, Outcome};
use super::report::Report;

/// Make a description of an ESI file.
///
/// What the description cannot say is reported on the standard error, and what had to be guessed, each with its place in
/// the file.
#[derive(Debug, Args)]
pub(super) struct Import {
    /// The ESI file.
    #[arg(value_name = "FILE.xml")]
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
        let bytes = read(&self.file)?;
        let name = self.file.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let choice = Choice { device: self.device.clone(), revision: self.revision };
        let imported = import(&bytes, &name, &choice).map_err(|refusal| self.refused(&refusal))?;
        let out = self.out.clone().unwrap_or_else(|| Path::new("devices").join(&imported.id));
        self.write(&out, &imported)?;
        let file = self.file.display().to_string();
        report.message(imported.report.text(&file).trim_end());
        if let Some(path) = &self.report {
            fs::write(path, imported.report.json(&file))
                .map_err(|error| Failure::at("write", path, &error))?;
        }
        let names: Vec<&str> = imported.files.keys().map(String::as_str).collect();
        report.line(&format!("{}: wrote {}", out.display(), names.join(", ")))?;
        Ok(Outcome::Clean)
    }

    fn refused(&self, refusal: &devc::import::Refusal) -> Failure {
        let place = refusal.place.map(|(line, column)| format!(":{line}:{column}")).unwrap_or_default();
        let failure =
            Failure::new(format!("cannot import `{}{place}`: {}", self.file.display(), refusal.why));
        if refusal.choices.is_empty() {
            return failure;
        }
        failure
            .help(format!("choose with `--device` and `--revision`:\n    {}", refusal.choices.join("\n    ")))
    }

    /// Writes all files, or none if one of them is there already.
    fn write(&self, out: &Path, imported: &Imported) -> Result<(), Failure> {
        fs::create_dir_all(out).map_err(|error| Failure::at("make the folder", out, &error))?;
        if !self.overwrite
            && let Some(path) = imported.files.keys().map(|name| out.join(name)).find(|path| path.exists())
        {
            let what = format!("`{}` is there already", path.display());
            return Err(Failure::new(what).help("give another folder by `--out`, or say `--overwrite`"));
        }
        for (name, text) in &imported.files {
            let path = out.join(name);
            let written = self.open(&path).and_then(|mut file| file.write_all(text.as_bytes()));
            written.map_err(|error| Failure::at("write", &path, &error))?;
        }
        Ok(())
    }

    /// A file that is not there yet, unless it may be written over.
    fn open(&self, path: &Path) -> std::io::Result<File> {
        match self.overwrite {
            true => File::create(path),
            false => File::options().write(true).create_new(true).open(path),
        }
    }
}

/// The bytes of a file, at most one more than is read of any.
fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    let fail = |error| Failure::at("read", path, &error);
    if fs::metadata(path).map_err(fail)?.is_dir() {
        return Err(fail(ErrorKind::IsADirectory.into()));
    }
    let mut bytes = Vec::new();
    let limit = u64::try_from(MAX_SIZE).unwrap_or(u64::MAX).saturating_add(1);
    File::open(path).and_then(|file| file.take(limit).read_to_end(&mut bytes)).map_err(fail)?;
    Ok(bytes)
}
