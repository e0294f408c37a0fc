//! From ESI to a description: the way back.
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

use self::read::Element;
use self::recognise::Draft;
use crate::diagnostic::Level;
use crate::source::Memory;
use crate::text::characters::hazard;

/// What came of a file.
#[derive(Debug)]
pub struct Imported {
    /// A name for the folder of the description.
    pub id: String,
    /// The files of the description by name.
    pub files: BTreeMap<String, String>,
    /// What was kept, lost and guessed.
    pub report: Report,
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

/// Imports a device of an ESI file. `name` is the file's, for the description to refer to.
///
/// # Errors
/// If the file is no ESI file, or has no such device, or several to choose from.
pub fn import(bytes: &[u8], name: &str, choice: &Choice) -> Result<Imported, Refusal> {
    let text = read::text(bytes).map_err(|why| Refusal { place: None, why, choices: Vec::new() })?;
    let root = read::root(&text).map_err(|(at, why)| Refusal {
        place: Some(place(&text, at)),
        why,
        choices: Vec::new(),
    })?;
    let elements = read::devices(&root);
    let heads: Vec<_> = elements.iter().map(|element| read::head(element)).collect();
    let chosen: Vec<&Element<'_>> =
        choice.of(&heads)?.into_iter().filter_map(|place| elements.get(place).copied()).collect();
    let esi = read::file(&root);
    let mut report = Report::default();
    let members = chosen.iter().map(|element| member(&esi, element, &mut report));
    let mut members = members
        .collect::<Result<Vec<(String, String, Draft)>, _>>()
        .map_err(|(at, why)| Refusal { place: Some(place(&text, at)), why, choices: Vec::new() })?;
    let odd = text.char_indices().find(|(_, c)| *c != '\r' && hazard(*c).is_some());
    if let Some((at, what)) = odd.and_then(|(at, c)| Some((at, hazard(c)?))) {
        report.guess(read::At(at), what, "descriptions have no place for it, and � stands there instead");
    }
    report.finish(&text);
    let alone = members.pop_if(|_| chosen.len() == 1).map(|(_, name, draft)| (name, draft));
    let family = || recognise::family(members).map(|draft| (draft.name(), draft));
    let (name_of_it, draft) = alone.or_else(family).ok_or_else(|| choose::several(&heads))?;
    let id = crate::model::ids::id(&name_of_it);
    let files = checked(&draft, name)?;
    Ok(Imported { id, files, report })
}

/// A device of a file as a description, with the word for it and its name.
fn member(
    esi: &read::Esi,
    element: &Element<'_>,
    report: &mut Report,
) -> Result<(String, String, Draft), (read::At, String)> {
    let device = read::device(element);
    if let Some(at) = device.excess {
        return Err((at, "its dictionary has more values than devc holds".to_owned()));
    }
    report.facts += element.facts();
    let draft = recognise::device(esi, &device, report);
    report.unread(element.unread());
    Ok((device.head.type_name, device.head.name, draft))
}

fn place(text: &str, at: read::At) -> (usize, usize) {
    let before = text.get(..at.0).unwrap_or(text);
    let line = before.rfind('\n').map_or(before, |place| before.get(place + 1..).unwrap_or_default());
    (before.matches('\n').count() + 1, line.chars().count() + 1)
}

/// The files, with the rules named that the vendor's data break. A description that devc refuses is not given out.
fn checked(draft: &Draft, name: &str) -> Result<BTreeMap<String, String>, Refusal> {
    let files = write::files(draft, name, &[]);
    let compilation = compiled(&files);
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
    Ok(if broken.is_empty() { files } else { write::files(draft, name, &broken) })
}

fn compiled(files: &BTreeMap<String, String>) -> crate::Compilation {
    let folder = Path::new("device");
    let memory = files
        .iter()
        .fold(Memory::new(), |memory, (name, text)| memory.with(folder.join(name), text.as_str()));
    crate::compile(&memory, folder)
}
