//! Following `include` from file to file.

use std::collections::BTreeSet;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::loader::{MAX_SIZE, Opened, clean, or_here, shown, similar};
use super::parse::parse;
use super::settings::Settings;
use super::{Layer, Loader, Location, SourceFile, Sources, Table, limits};
use crate::diagnostic::{Diagnostic, Diagnostics, faults};

/// How many files may include one another in a row.
const MAX_DEPTH: usize = 64;

/// Reads files, each once.
pub(super) struct Reader<'a> {
    loader: &'a dyn Loader,
    /// The canonical folder that no include may leave.
    folder: PathBuf,
    /// The folder in which the first file was found when it was opened.
    opened: Option<PathBuf>,
    sources: &'a mut Sources,
    diagnostics: &'a mut Diagnostics,
    /// The files whose includes are being followed, outermost first: canonical, and as shown.
    chain: Vec<(PathBuf, String)>,
    /// The canonical paths of all files seen.
    seen: BTreeSet<PathBuf>,
    /// How many includes were followed.
    followed: usize,
    /// How many bytes were read.
    bytes: usize,
    /// What was read.
    pub(super) parts: Vec<Part>,
    /// Where it was read from.
    pub(super) files: Vec<PathBuf>,
}

/// One file of a description.
pub(super) struct Part {
    pub(super) table: Table,
    pub(super) settings: Settings,
}

impl<'a> Reader<'a> {
    /// A reader for the description that starts with the file `main`.
    pub(super) fn new(
        loader: &'a dyn Loader,
        main: &Path,
        sources: &'a mut Sources,
        diagnostics: &'a mut Diagnostics,
    ) -> Option<Self> {
        let folder = loader.canonical(main).ok()?.parent()?.to_owned();
        let (chain, seen, parts, files) = (Vec::new(), BTreeSet::new(), Vec::new(), Vec::new());
        let opened = None;
        Some(Self {
            loader,
            folder,
            opened,
            sources,
            diagnostics,
            chain,
            seen,
            followed: 0,
            bytes: 0,
            parts,
            files,
        })
    }

    /// Reads the first file and all it includes.
    pub(super) fn read(&mut self, main: &Path) {
        match self.loader.canonical(main) {
            Ok(canonical) => self.enter(main, canonical, None),
            Err(error) => {
                let message = format!("`{}` {}", shown(main), reason(&error));
                self.diagnostics.push(Diagnostic::bare(&faults::UNREADABLE_FILE, message));
            }
        }
    }

    fn enter(&mut self, path: &Path, canonical: PathBuf, from: Option<(&str, Location)>) {
        self.seen.insert(canonical.clone());
        let at = from.map(|(_, at)| at);
        let (name, text) = match self.text(path) {
            Ok(read) => read,
            Err(fault) => return self.diagnostics.push(fault.at(at)),
        };
        // A link may have been turned since it was looked at: what counts is where the text is from.
        let folder = self.opened.get_or_insert_with(|| name.parent().unwrap_or(&name).to_owned());
        if let Some((name, at)) = from.filter(|_| !name.starts_with(folder)) {
            return self.diagnostics.push(outside(name, at));
        }
        let shown = self.shown(path, &canonical);
        let source = SourceFile { path: shown.clone(), text, embedded: false };
        let file = self.sources.add_read(source, name);
        self.files.push(path.to_owned());
        let text = self.sources.get(file).map_or("", |file| file.text.as_str());
        let mut table = parse(file, text, Layer::Description, self.diagnostics);
        let settings = Settings::take(&mut table, self.diagnostics);
        let includes = settings.include.clone();
        self.parts.push(Part { table, settings });
        self.chain.push((canonical, shown));
        for (name, at) in includes {
            self.follow(path, &name, at);
        }
        self.chain.pop();
    }

    fn follow(&mut self, from: &Path, name: &Arc<str>, at: Location) {
        self.followed += 1;
        if self.followed > limits::FILES {
            return self.diagnostics.push(limits::includes(at));
        }
        let path = from.parent().unwrap_or(Path::new("")).join(&**name);
        let canonical = match self.loader.canonical(&path) {
            Ok(canonical) => canonical,
            Err(error) => return self.diagnostics.push(self.missing(&path, name, at, &error)),
        };
        if !canonical.starts_with(&self.folder) {
            return self.diagnostics.push(outside(name, at));
        }
        if let Some(start) = self.chain.iter().position(|(open, _)| *open == canonical) {
            return self.diagnostics.push(self.cycle(start, name, at));
        }
        if self.chain.len() >= MAX_DEPTH {
            let message = format!("more than {MAX_DEPTH} files include one another in a row");
            return self.diagnostics.push(Diagnostic::new(&faults::INCLUDE_CYCLE, message, at, "not read"));
        }
        if !self.seen.contains(&canonical) {
            self.enter(&path, canonical, Some((name, at)));
        }
    }

    /// The path as people see it, without `..` if it leads to the same file then.
    fn shown(&self, path: &Path, canonical: &Path) -> String {
        let short = clean(path);
        let same = short == path || self.loader.canonical(&short).is_ok_and(|name| name == canonical);
        shown(if same { &short } else { path })
    }

    /// The name and the text of what the path leads to.
    fn text(&mut self, path: &Path) -> Result<(PathBuf, String), Unreadable> {
        let unreadable = |why: String| Unreadable { message: format!("`{}` {why}", shown(path)), help: None };
        let Opened { name, bytes } = self.loader.read(path).map_err(|error| unreadable(reason(&error)))?;
        if bytes.len() > MAX_SIZE {
            return Err(unreadable(format!("is larger than {} MiB", MAX_SIZE >> 20)));
        }
        self.bytes += bytes.len();
        if self.bytes > MAX_SIZE {
            return Err(unreadable(format!("makes the description larger than {} MiB", MAX_SIZE >> 20)));
        }
        let text = String::from_utf8(bytes).map_err(|error| {
            let offset = error.utf8_error().valid_up_to();
            let line = 1 + error.as_bytes().iter().take(offset).filter(|byte| **byte == b'\n').count();
            let help = Some("save the file as UTF-8".to_owned());
            Unreadable { help, ..unreadable(format!("is not UTF-8 at byte {offset}, in line {line}")) }
        })?;
        Ok((name, text))
    }

    fn missing(&self, path: &Path, name: &str, at: Location, error: &std::io::Error) -> Diagnostic {
        // Whether there is such a file elsewhere, and what lies beside it, is not devc's business.
        if self.way(path).is_some_and(|folder| !folder.starts_with(&self.folder)) {
            return outside(name, at);
        }
        if error.kind() != ErrorKind::NotFound {
            let message = format!("`{}` {}", shown(path), reason(error));
            return Diagnostic::new(&faults::UNREADABLE_FILE, message, at, "included here");
        }
        let message = format!("`{}` does not exist", shown(path));
        let diagnostic = Diagnostic::new(&faults::MISSING_FILE, message, at, "included here");
        let wrong = path.file_name().unwrap_or_default().to_string_lossy();
        let has_room = self.diagnostics.has_room(&faults::MISSING_FILE);
        let near = has_room.then(|| similar(self.loader, path)).flatten();
        match (near, name.strip_suffix(&*wrong)) {
            (Some(near), Some(way)) if is_bare(&near) && is_bare(way) => {
                diagnostic.fix(format!("did you mean `{near}`?"), at, format!("\"{way}{near}\""))
            }
            (Some(near), _) => diagnostic.help(format!("`{near}` lies there")),
            (None, _) => diagnostic.note("an include is relative to the file that names it"),
        }
    }

    /// How far a path leads that does not lead to a file: the canonical name of the last folder that is there.
    fn way(&self, path: &Path) -> Option<PathBuf> {
        path.ancestors().skip(1).find_map(|folder| self.loader.canonical(or_here(folder)).ok())
    }

    fn cycle(&self, start: usize, name: &str, at: Location) -> Diagnostic {
        let names: Vec<&str> = self.chain.iter().skip(start).map(|(_, shown)| shown.as_str()).collect();
        let first = names.first().copied().unwrap_or_default();
        let message = format!("`{first}` includes itself");
        let label = if names.len() == 1 { String::new() } else { format!("`{name}` is being read already") };
        Diagnostic::new(&faults::INCLUDE_CYCLE, message, at, label)
            .note(format!("the includes are {} -> {first}", names.join(" -> ")))
            .help("remove one of them")
    }
}

/// Whether a text can stand between quotation marks as it is.
fn is_bare(text: &str) -> bool {
    !text.contains(|c: char| c.is_control() || matches!(c, '"' | '\\'))
}

/// A file that cannot be read as text.
struct Unreadable {
    message: String,
    help: Option<String>,
}

impl Unreadable {
    fn at(self, at: Option<Location>) -> Diagnostic {
        let rule = &faults::UNREADABLE_FILE;
        let diagnostic = match at {
            Some(at) => Diagnostic::new(rule, self.message, at, "included here"),
            None => Diagnostic::bare(rule, self.message),
        };
        match self.help {
            Some(help) => diagnostic.help(help),
            None => diagnostic,
        }
    }
}

/// That a file is named which is none of the description's.
pub(crate) fn outside(name: &str, at: Location) -> Diagnostic {
    let message = format!("`{name}` lies outside the folder of the description");
    Diagnostic::new(&faults::OUTSIDE_INCLUDE, message, at, "leaves the folder")
        .note("a description is one folder that can be moved as a whole; links are followed")
        .help("copy the file into the folder of the description")
}

/// Why a file cannot be read, the same on every machine where it can be.
fn reason(error: &std::io::Error) -> String {
    match error.kind() {
        ErrorKind::NotFound => "does not exist".to_owned(),
        ErrorKind::PermissionDenied => "cannot be read: permission denied".to_owned(),
        ErrorKind::IsADirectory => "is a folder, not a file".to_owned(),
        _ => format!("cannot be read: {error}"),
    }
}
