//! A description as files, laid out as the shipped ones are.

mod alike;
mod layout;

use std::collections::BTreeMap;

use super::read::Format;
use super::recognise::{Block, Draft};
use super::toml::Toml;
use layout::Section;

/// How many lines a description may have in one file.
const MOST_LINES: usize = 150;

/// The files of a description by name. `from` is the name of the file that it comes from, `lints` are rules that it
/// breaks.
pub(super) fn files(draft: &Draft, format: Format, from: &str, lints: &[String]) -> BTreeMap<String, String> {
    let pdos = Section::of(&draft.pdos).text();
    let objects = Section::of(&alike::alike(&draft.objects, &draft.profiles)).text();
    let diagnosis = Section::of(&draft.diagnosis).text();
    let members = Section::of(&draft.members).text();
    let device = Section::of(&draft.device).text();
    let parts = [
        ("members.toml", "What members have of their own", members),
        ("pdos.toml", "Process data", pdos),
        ("objects.toml", "The dictionary", objects),
        ("diagnosis.toml", "Messages of the diagnosis history", diagnosis),
    ];
    let lines: usize = parts.iter().map(|(_, _, text)| text.lines().count()).sum();
    let apart = lines > MOST_LINES;
    let included: Vec<&str> =
        parts.iter().filter(|part| apart && !part.2.is_empty()).map(|part| part.0).collect();
    let mut main = head(draft, from, &included);
    main.push_str(&device);
    let mut files = BTreeMap::new();
    for (name, title, text) in parts.into_iter().filter(|part| !part.2.is_empty()) {
        if apart {
            files.insert(
                name.to_owned(),
                format!("# {title}.\n\nsource = {}\n\n{text}", Toml::text(from).inline()),
            );
        } else {
            main.push_str(&text);
        }
    }
    main.push_str(&last(format, from, lints));
    files.insert("device.toml".to_owned(), main.trim_end().to_owned() + "\n");
    files
}

/// What stands before the first table.
fn head(draft: &Draft, from: &str, included: &[&str]) -> String {
    let mut text = format!("# Imported from {from}; from now on this is the source.\n\n");
    if !draft.remarks.is_empty() {
        text += &(layout::remarks(&draft.remarks) + "\n");
    }
    text += &format!("source   = {}\n", Toml::text(from).inline());
    text += &format!("profiles = {}\n", Toml::texts(draft.profiles.iter().copied()).inline());
    if !included.is_empty() {
        text += &format!("include  = {}\n", Toml::texts(included.iter().copied()).inline());
    }
    if !draft.without.is_empty() {
        text += "\n# What a profile brings and the device does not have.\nwithout = [\n";
        text += &filled(&draft.without);
        text += "]\n";
    }
    text + "\n"
}

/// Items of a list, as many in a line as fit.
fn filled(items: &[String]) -> String {
    const WIDTH: usize = 120;
    let mut lines: Vec<String> = Vec::new();
    for item in items.iter().map(|item| format!("{},", Toml::text(item).inline())) {
        match lines.last_mut().filter(|line| line.len() + 1 + item.len() <= WIDTH) {
            Some(line) => *line += &format!(" {item}"),
            None => lines.push(format!("    {item}")),
        }
    }
    lines.iter().map(|line| format!("{line}\n")).collect()
}

/// The document that the facts are from, and the rules that the vendor's data break.
fn last(format: Format, from: &str, lints: &[String]) -> String {
    let (key, what) = format.document();
    let title = Toml::text(format!("{what}, {from}")).inline();
    let mut text = format!("[documents.{key}]\ntitle = {title}\n\n");
    if !lints.is_empty() {
        text += "# Rules that the vendor's data break: to be mended, or answered by an erratum.\n[lints]\n";
        for rule in lints {
            text += &format!("{rule} = \"warn\"\n");
        }
    }
    text
}
