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

/// The files besides `device.toml`, with what they are headed by.
const PARTS: [(&str, &str); 4] = [
    ("members.toml", "What members have of their own"),
    ("pdos.toml", "Process data"),
    ("objects.toml", "The dictionary"),
    ("diagnosis.toml", "Messages of the diagnosis history"),
];

/// What of an earlier import may lie beside its `device.toml`, of which the text is given: the names of files, each with how
/// it begins.
pub(super) fn earlier(device: &str) -> Vec<(&'static str, String)> {
    let from = device.lines().next().and_then(|line| line.strip_prefix("# Imported from "));
    let Some(from) = from.and_then(|line| line.strip_suffix(FROM_NOW_ON)) else { return Vec::new() };
    PARTS.into_iter().map(|(name, title)| (name, beginning(title, from))).collect()
}

/// How the first line of a description ends.
const FROM_NOW_ON: &str = "; from now on this is the source.";

fn beginning(title: &str, from: &str) -> String {
    format!("# {title}.\n\nsource = {}\n", Toml::text(from).inline())
}

/// The files of a description by name. `from` is the name of the file that it comes from, `lints` are rules that it
/// breaks.
pub(super) fn files(draft: &Draft, format: Format, from: &str, lints: &[String]) -> BTreeMap<String, String> {
    let pdos = Section::of(&draft.pdos).text();
    let objects = Section::of(&alike::alike(&draft.objects, &draft.profiles)).text();
    let diagnosis = Section::of(&draft.diagnosis).text();
    let members = Section::of(&draft.members).text();
    let device = Section::of(&draft.device).text();
    let texts = [members, pdos, objects, diagnosis];
    let parts: Vec<_> =
        PARTS.into_iter().zip(texts).map(|((name, title), text)| (name, title, text)).collect();
    let lines: usize = parts.iter().map(|(_, _, text)| text.lines().count()).sum();
    let apart = lines > MOST_LINES;
    let included: Vec<&str> =
        parts.iter().filter(|part| apart && !part.2.is_empty()).map(|part| part.0).collect();
    let mut main = head(draft, from, &included);
    main.push_str(&device);
    let mut files = BTreeMap::new();
    for (name, title, text) in parts.into_iter().filter(|part| !part.2.is_empty()) {
        if apart {
            files.insert(name.to_owned(), format!("{}\n{text}", beginning(title, from)));
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
    let mut text = format!("# Imported from {from}{FROM_NOW_ON}\n\n");
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
