//! The reference: what makes it a document that people can use, for every description that is shipped.

#![cfg(test)]

mod marks;
mod notation;
mod parameters;
mod provenance;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use devc::emit::Emitter;
use devc::emit::markdown::Markdown;
use devc::lint::Checked;
use devc::model::Family;
use devc::source::{Disk, Memory};

/// A description with next to nothing in it, whose chapters are empty.
const BARE: &str = "
[device]
name = \"Bare | <b>\"
vendor = \"Nobody\"

[identity]
vendor-id = 1
product-code = 1
revision = 1
";

/// The folders of the descriptions that are shipped.
fn folders() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices");
    let mut folders: Vec<PathBuf> =
        fs::read_dir(root).unwrap().map(|folder| folder.unwrap().path()).collect();
    folders.sort();
    folders
}

/// Every shipped family with its reference.
fn references() -> Vec<(Family, String)> {
    let folders = folders();
    let compiled = folders.iter().map(|folder| {
        let family = devc::compile(&Disk, folder).family.unwrap_or_else(|| panic!("{}", folder.display()));
        let text = reference(&family);
        (Family::clone(&family), text)
    });
    compiled.collect()
}

/// What stands between `open` and `close`, each time.
fn between<'a>(text: &'a str, open: &'a str, close: char) -> impl Iterator<Item = &'a str> {
    text.split(open).skip(1).filter_map(move |rest| rest.split(close).next())
}

fn reference(family: &Checked<Family>) -> String {
    let files = Markdown.emit(family, &devc::emit::Options::default());
    files.text(".md").expect("a reference").to_owned()
}

/// The reference of a description with next to nothing but this.
fn described(text: &str) -> String {
    let loader = Memory::new().with("/bare/device.toml", format!("{BARE}{text}"));
    let compilation = devc::compile(&loader, Path::new("/bare"));
    let messages: Vec<_> = compilation.diagnostics.iter().map(|message| &message.message).collect();
    reference(&compilation.family.unwrap_or_else(|| panic!("{messages:?}")))
}

#[test]
fn every_chapter_can_be_printed() {
    for (family, text) in references() {
        assert!(!text.contains("could not print"), "{}", family.id);
    }
}

#[test]
fn every_link_leads_somewhere_and_every_anchor_is_unique() {
    for (family, text) in references() {
        let mut anchors = BTreeSet::new();
        for anchor in between(&text, "<a id=\"", '"') {
            assert!(anchors.insert(anchor), "{}: anchor {anchor} twice", family.id);
        }
        for link in between(&text, "](#", ')') {
            assert!(anchors.contains(link), "{}: nothing at #{link}", family.id);
        }
    }
}

/// The files of a reference whose chapters are files.
fn chapters(family: &Checked<Family>) -> BTreeMap<String, String> {
    let options = devc::emit::Options { chapters: true, ..Default::default() };
    let files = Markdown.emit(family, &options).0.into_iter();
    files.map(|(name, content)| (name, String::from_utf8(content).unwrap())).collect()
}

#[test]
fn links_of_chapters_lead_to_the_file_that_has_the_place() {
    for folder in folders() {
        let family = devc::compile(&Disk, &folder).family.unwrap();
        let files = chapters(&family);
        assert!(files.len() > 10, "{}", family.id);
        for (name, text) in &files {
            let end = name.strip_prefix(&family.id).unwrap();
            assert!(Markdown.ends().contains(&end), "{name} is no name of this output");
            let folder = name.rsplit_once('/').map_or("", |(folder, _)| folder);
            let local = between(text, "](", ')').filter(|link| link.contains(".md") || link.starts_with('#'));
            for link in local.filter(|link| !link.contains("://")) {
                let (file, place) = link.split_once('#').unwrap_or((link, ""));
                let file = match file.strip_prefix("../") {
                    Some(above) => above.to_owned(),
                    None if file.is_empty() => name.clone(),
                    None if folder.is_empty() => file.to_owned(),
                    None => format!("{folder}/{file}"),
                };
                let there = files.get(&file).unwrap_or_else(|| panic!("{name}: no file at {link}"));
                let anchor = format!("<a id=\"{place}\">");
                assert!(place.is_empty() || there.contains(&anchor), "{name}: nothing at {link}");
            }
        }
        let index = &files[&format!("{}.md", family.id)];
        for name in files.keys().filter(|name| name.contains('/')) {
            assert!(index.contains(&format!("]({name}#")), "{name} is not in the contents");
        }
    }
}

#[test]
fn chapters_say_what_the_one_file_says() {
    for folder in folders() {
        let family = devc::compile(&Disk, &folder).family.unwrap();
        let files = chapters(&family);
        // Where a link leads is the one thing that differs.
        let bare = |line: &str| {
            let mut pieces = line.split("](");
            let first = pieces.next().unwrap().to_owned();
            let rest = pieces.map(|piece| piece.split_once('#').map_or(piece, |(_, place)| place));
            rest.fold(first, |line, piece| line + "](" + piece)
        };
        let mut said: BTreeMap<String, usize> = BTreeMap::new();
        for line in files.values().flat_map(|text| text.lines()) {
            *said.entry(bare(line)).or_default() += 1;
        }
        for line in reference(&family).lines().filter(|line| !line.is_empty()) {
            let left = said.get_mut(&bare(line)).filter(|left| **left > 0);
            *left.unwrap_or_else(|| panic!("{}: {line} is missing", family.id)) -= 1;
        }
    }
}

#[test]
fn every_row_has_the_cells_of_its_table() {
    let cells = |line: &str| line.replace("\\|", "").matches('|').count();
    for (family, text) in references() {
        let lines: Vec<&str> = text.lines().collect();
        for pair in lines.windows(2) {
            if pair.iter().all(|line| line.starts_with('|')) {
                assert_eq!(cells(pair[0]), cells(pair[1]), "{}: {pair:#?}", family.id);
            }
        }
    }
}

#[test]
fn every_object_pdo_and_error_is_there() {
    for (family, text) in references() {
        for device in &family.members {
            let objects = device.objects.iter().map(|object| object.index);
            let pdos = device.pdos.iter().map(|pdo| pdo.index);
            for index in objects.chain(pdos) {
                assert!(text.contains(&format!("`{index}`")), "{}: {index} is missing", device.id);
            }
            for error in &device.errors {
                assert!(text.contains(&format!("`0x{:04X}`", error.code)), "{}: {error:?}", device.id);
            }
        }
    }
}

/// What the members of a family share stands once.
#[test]
fn every_heading_stands_once() {
    for (family, text) in references() {
        let mut headings = BTreeSet::new();
        for heading in text.lines().filter(|line| line.starts_with("##")) {
            assert!(headings.insert(heading), "{}: {heading} twice", family.id);
        }
    }
}

#[test]
fn what_tells_members_apart_is_said_of_each() {
    let (_, text) = references().into_iter().find(|(family, _)| family.id == "s700").unwrap();
    assert!(text.contains("|  | S300 | S400 | S600 | S700 |"), "{text}");
    let only = "`0x1600` Free mapping\n\n*Only S300 and S700.*";
    assert!(text.contains(only), "the free mapping names its members");
    let assigned = "*S400 and S600:* **6\u{A0}bytes** · assigned by default";
    assert!(text.contains(assigned), "a default names its members");
}

#[test]
fn the_sums_of_the_c887_are_those_of_its_manual() {
    let (_, text) = references().into_iter().find(|(family, _)| family.id == "c887").unwrap();
    assert!(text.contains("image of 42\u{A0}bytes"), "outputs");
    assert!(text.contains("image of 66\u{A0}bytes"), "inputs");
    assert!(text.contains("| 1\u{A0}ms | **14\u{A0}ms** |"), "dead time");
    assert!(text.contains("| 2\u{A0}ms | **18\u{A0}ms** |"), "dead time");
    assert!(text.contains("12.5 mm ↔ 1\u{202F}250\u{202F}000"), "scaling");
}

#[test]
fn what_is_empty_vanishes_with_its_line_of_the_contents() {
    let text = described("");
    let chapters: Vec<&str> = text.lines().filter(|line| line.starts_with("## ")).collect();
    assert!(chapters.contains(&"## <a id=\"device\"></a>Device"), "{text}");
    assert!(!text.contains("Modes of operation") && !text.contains("Errors"), "{text}");
    assert!(text.contains(r"# Bare \| \<b>"), "{text}");
    assert_eq!(chapters.len() - 1, text.lines().filter(|line| line.starts_with("- [")).count(), "{text}");
}

/// A drive whose torque is in tenths of a percent: raw 4000 is 400 %, and so does the reference say.
#[test]
fn raw_limits_are_said_in_their_unit() {
    let objects = "
[objects.0x2000]
name = \"Torque limits\"
type = \"INT16\"
access = \"rw\"
unit = \"torque\"
min = -4000
max = 4000
default = 1005

[units.torque]
quantity = \"torque\"
symbol = \"%\"
raw-per-unit = 10
";
    let text = described(objects);
    assert!(text.contains("`-4000` to `4000` (−400 to 400 %)"), "{text}");
    assert!(text.contains("`1005` (100.5 %)"), "{text}");
}
