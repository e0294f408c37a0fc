//! From ESI, EDS and lists of SDO information to a description: the way back.
//!
//! A file is read as it is, what it means is put into the words of a description, and that is laid out as files. What of
//! the file the description does not say is in the report; since elements remember whether they were read, nothing is
//! left out in silence.

mod choose;
mod read;
mod recognise;
mod report;
mod toml;
mod write;

pub use choose::Choice;
pub use report::{Note, NoteKind, Report};

use std::collections::BTreeMap;
use std::path::Path;

use self::read::{Element, Format, List, Sheet};
use self::recognise::Draft;
use crate::diagnostic::Level;
use crate::model::Pdo;
use crate::source::Memory;
use crate::text::characters::hazard;

/// What came of a file.
#[derive(Debug)]
pub struct Imported {
    /// A name for the folder of the description.
    pub id: String,
    /// The files of the description by name.
    pub files: BTreeMap<String, String>,
    /// The pictures that it names, by the names of their files.
    pub pictures: BTreeMap<String, Vec<u8>>,
    /// What was kept, lost and guessed.
    pub report: Report,
}

impl Imported {
    /// All files in a folder, to be compiled from memory.
    pub fn in_memory(&self, folder: impl AsRef<Path>) -> Memory {
        in_memory(folder.as_ref(), &self.files, &self.pictures)
    }
}

/// Why nothing came of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// The line and the column, if it is about a place.
    pub place: Option<(usize, usize)>,
    /// What is wrong.
    pub why: String,
    /// What can be chosen from, if there is a choice.
    pub choices: Vec<String>,
}

/// What of an earlier import may lie beside its `device.toml`, of which the text is given: the names of files, each with how
/// it begins. Nothing if no import made it.
pub fn earlier(device: &str) -> Vec<(&'static str, String)> {
    write::earlier(device)
}

/// Imports a device of an ESI file, of an EDS, or of the list that `ethercat sdos` prints. `name` is the file's, for the
/// description to refer to.
///
/// # Errors
/// If the file is none of these, or has no such device, or several to choose from.
pub fn import(bytes: &[u8], name: &str, choice: &Choice) -> Result<Imported, Refusal> {
    let text = read::text(bytes).map_err(|why| Refusal { place: None, why, choices: Vec::new() })?;
    if let Some(encoding) = read::foreign(bytes, &text) {
        return Err(Refusal { place: Some((1, 1)), why: unread(encoding), choices: Vec::new() });
    }
    let format = Format::of(&text);
    let mut report = Report::default();
    let odd = text.char_indices().find(|(_, c)| *c != '\r' && hazard(*c).is_some());
    if let Some((at, what)) = odd.and_then(|(at, c)| Some((at, hazard(c)?))) {
        report.guess(read::At(at), what, "descriptions have no place for it, and � stands there instead");
    }
    if read::is_miscoded(bytes, &text) {
        let why = "it says none but UTF-8, and its bytes are not; Windows-1252 is taken";
        report.guess(read::At(0), "the encoding", why);
    }
    let mut pictures = BTreeMap::new();
    if let Some((at, why)) = read::entities(&text) {
        report.guess(at, "entities", why);
    }
    let (name_of_it, mut draft) = match format {
        Format::Esi => of_esi(&text, choice, &mut pictures, &mut report)?,
        Format::Eds => of_sheet(&text, &mut report)?,
        Format::Sdos => of_list(&text, &mut report)?,
    };
    draft.remark(report.guessed_since(0));
    report.finish(&text);
    let id = crate::model::ids::id(&name_of_it);
    let files = checked(&draft, format, name, &pictures)?;
    Ok(Imported { id, files, pictures, report })
}

/// Why a file in such an encoding is not read, and how it can be.
fn unread(encoding: &str) -> String {
    // A name from a file stands in a command only if a shell takes it for a word.
    let is_word = encoding.chars().all(|c| c.is_ascii_alphanumeric() || "-_.".contains(c));
    let command = if is_word { format!(", as `iconv -f {encoding} -t UTF-8` does") } else { String::new() };
    format!("it is in `{}`, which is not read; save it as UTF-8{command}", report::shortened(encoding))
}

/// A device of an ESI file, or several that are a family.
fn of_esi(
    text: &str,
    choice: &Choice,
    pictures: &mut BTreeMap<String, Vec<u8>>,
    report: &mut Report,
) -> Result<(String, Draft), Refusal> {
    let root = read::root(text).map_err(|fault| refusal(text, fault))?;
    let devices = |info| read::devices(info).into_iter().map(move |device| (info, device));
    let elements: Vec<(&Element<'_>, &Element<'_>)> =
        read::infos(&root).into_iter().flat_map(devices).collect();
    let heads: Vec<_> = elements.iter().map(|(_, element)| read::head(element)).collect();
    let chosen: Vec<_> =
        choice.of(&heads)?.into_iter().filter_map(|place| elements.get(place).copied()).collect();
    let members = chosen.iter().map(|it| member(*it, report));
    let mut members =
        members.collect::<Result<Vec<(String, String, Draft)>, _>>().map_err(|fault| refusal(text, fault))?;
    *pictures = self::pictures(members.iter_mut().map(|(_, _, draft)| draft));
    let alone = members.pop_if(|_| chosen.len() == 1).map(|(_, name, draft)| (name, draft));
    let family = || recognise::family(members).map(|draft| (draft.name(), draft));
    alone.or_else(family).ok_or_else(|| choose::several(&heads))
}

/// The pictures of devices in files, each once.
fn pictures<'d>(drafts: impl Iterator<Item = &'d mut Draft>) -> BTreeMap<String, Vec<u8>> {
    let mut pictures: BTreeMap<String, Vec<u8>> = BTreeMap::new();
    for draft in drafts {
        let Some(picture) = draft.picture.take() else { continue };
        let known = pictures.iter().find(|(_, known)| **known == picture).map(|(name, _)| name.clone());
        let name = known.unwrap_or_else(|| match pictures.len() {
            0 => "picture.bmp".to_owned(),
            others => format!("picture-{}.bmp", others + 1),
        });
        draft.picture_in(&name);
        pictures.insert(name, picture);
    }
    pictures
}

/// The device of an EDS.
fn of_sheet(text: &str, report: &mut Report) -> Result<(String, Draft), Refusal> {
    let sheet = Sheet::parse(text).map_err(|fault| refusal(text, fault))?;
    let (vendor, mut device) = read::sheet_device(&sheet);
    recognise::take_out(&mut device);
    report.facts += sheet.facts();
    let draft = recognise::device(&vendor, &device, report);
    report.unread(sheet.unread());
    Ok((draft.name(), draft))
}

/// The device that a list of SDO information is of.
fn of_list(text: &str, report: &mut Report) -> Result<(String, Draft), Refusal> {
    let List { vendor, device, facts, unread, without_rights } =
        read::list(text).map_err(|fault| refusal(text, fault))?;
    report.facts += facts;
    if let Some(at) = without_rights {
        report.guess(at, "who may read and write", "the list does not say it; all is taken for read only");
    }
    let draft = recognise::device(&vendor, &device, report);
    report.unread(unread);
    Ok((draft.name(), draft))
}

fn refusal(text: &str, (at, why): (read::At, String)) -> Refusal {
    Refusal { place: Some(place(text, at)), why, choices: Vec::new() }
}

/// A device of a file as a description, with the word for it and its name.
fn member(
    (info, element): (&Element<'_>, &Element<'_>),
    report: &mut Report,
) -> Result<(String, String, Draft), (read::At, String)> {
    let (mut device, modules) = read::device(info, element);
    if let Some(at) = device.excess {
        return Err((at, "its dictionary has more values than devc holds".to_owned()));
    }
    let mut pdos = device.rx_pdos.iter().chain(&device.tx_pdos);
    if let Some(pdo) = pdos.find(|pdo| pdo.entries.len() > Pdo::ROOM) {
        let why = format!("its PDO 0x{:04X} has {} entries; {} fit", pdo.index, pdo.entries.len(), Pdo::ROOM);
        return Err((pdo.at, why));
    }
    let parts = || std::iter::once(&element).chain(&modules);
    report.facts += parts().map(|part| part.facts()).sum::<usize>();
    recognise::take_out(&mut device);
    let draft = recognise::device(&read::file(info), &device, report);
    parts().for_each(|part| report.unread(part.unread()));
    Ok((device.head.type_name, device.head.name, draft))
}

fn place(text: &str, at: read::At) -> (usize, usize) {
    let before = text.get(..at.0).unwrap_or(text);
    let line = before.rfind('\n').map_or(before, |place| before.get(place + 1..).unwrap_or_default());
    (before.matches('\n').count() + 1, line.chars().count() + 1)
}

/// The files, with the rules named that the vendor's data break. A description that devc refuses is not given out.
fn checked(
    draft: &Draft,
    format: Format,
    name: &str,
    pictures: &BTreeMap<String, Vec<u8>>,
) -> Result<BTreeMap<String, String>, Refusal> {
    let files = write::files(draft, format, name, &[]);
    let folder = Path::new("device");
    let compilation = crate::compile(&in_memory(folder, &files, pictures), folder);
    let errors = || compilation.diagnostics.iter().filter(|it| it.level == Level::Error);
    if let Some(fault) = errors().find(|it| it.rule.fixed) {
        let at = fault.at().and_then(|at| compilation.sources.slice(at)).unwrap_or_default();
        let why = format!(
            "what it says cannot be a description: {}, at `{}`",
            fault.message,
            report::shortened(at)
        );
        return Err(Refusal { place: None, why, choices: Vec::new() });
    }
    let mut broken: Vec<String> = errors().map(|it| it.rule.name.to_owned()).collect();
    broken.sort();
    broken.dedup();
    Ok(if broken.is_empty() { files } else { write::files(draft, format, name, &broken) })
}

fn in_memory(
    folder: &Path,
    files: &BTreeMap<String, String>,
    pictures: &BTreeMap<String, Vec<u8>>,
) -> Memory {
    let texts = files.iter().map(|(name, text)| (name, text.as_bytes()));
    let all = texts.chain(pictures.iter().map(|(name, bytes)| (name, bytes.as_slice())));
    all.fold(Memory::new(), |memory, (name, bytes)| memory.with(folder.join(name), bytes))
}
