//! Every output against every kind of dangerous character, in every place of a description that takes text.
//!
//! The way in refuses most of them, so the test goes around it: it changes the tree behind the parser.

#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::{Arc, LazyLock};

use proc_macro2::{TokenStream, TokenTree};
use quick_xml::events::Event;

use super::skeleton::{program, sheet};
use super::{ALL, Options, emit};
use crate::diagnostic::{Diagnostic, Diagnostics, Level};
use crate::lint::{Checked, Levels, check};
use crate::model::Family;
use crate::source::{Disk, Document, Loader, Location, Memory, Node, Sources, Table, Value};
use crate::text::characters::hazard;
use crate::{lint, profiles, raw, resolve, source};

/// What no output can hold, a few of each kind.
const HAZARDS: &str = "\0\u{7}\u{8}\r\u{1B}[31m\u{7F}\u{85}\u{9B}31m\u{2028}\u{2029}\u{202E}\u{2066}\u{200F}\u{61C}\u{AD}\u{200B}\u{FEFF}\u{FFFE}\u{FFFF}\u{1FFFE}\u{E0041}";

/// What means something to XML, Markdown, HTML, Mermaid, Rust or TOML. No colon is among it, since in a reference one
/// stands before a subindex.
const MARKUP: &str = "x'\"<b x=\"1\">&amp;]]>-->--*/ /*// | `a``b```[c](d)](#e \\\\ \\ {x} {{y}} {%z%} \nf\n# g\n- h\n\ti $j$ ~~k~~ %0A ;#";

/// The ends of files that hold bytes, whatever the texts are.
const BYTES: [&str; 2] = ["bin", "hex"];

/// The text that is put at the end of others, and exchanged for dangerous ones when it is known where it can be.
const MARK: &str = "qzq";

/// Where texts stand: a path in which the names that a description gives itself are stars.
type Places = BTreeSet<String>;

fn load(loader: &dyn Loader, path: &Path) -> (Document, Sources) {
    let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
    let document = source::load(loader, path, profiles::ALL, &mut sources, &mut diagnostics);
    (document.expect("the description can be read"), sources)
}

/// The tree with each text changed as its place wants it.
fn changed(table: &Table, path: &str, change: &mut dyn FnMut(&str, &str, Location) -> String) -> Table {
    const BY_NAME: [&str; 8] =
        ["entries", "bits", "values", "per-axis", "groups", "causes", "bytes", "mapping"];
    let section = path.rsplit('/').next().unwrap_or_default();
    let by_name = path.split('/').count() == 2 || BY_NAME.contains(&section);
    let members = table.members.iter().map(|member| {
        let mut member = member.clone();
        let key = if by_name { "*" } else { &*member.key.name };
        member.node = node(&member.node, &format!("{path}/{key}"), change);
        member
    });
    Table { at: table.at, members: members.collect() }
}

fn node(old: &Node, path: &str, change: &mut dyn FnMut(&str, &str, Location) -> String) -> Node {
    let value = match &old.value {
        Value::String(text) => Value::String(change(path, text, old.at).into()),
        Value::Table(table) => Value::Table(Arc::new(changed(table, path, change))),
        Value::Array(items) => Value::Array(items.iter().map(|item| node(item, path, change)).collect()),
        other => other.clone(),
    };
    Node { at: old.at, value }
}

/// The tree with something else in place of the mark, in keys and texts.
fn exchanged(table: &Table, with: &str) -> Table {
    let mut table = changed(table, "", &mut |_, text, _| text.replace(MARK, with));
    fn rename(table: &mut Table, with: &str) {
        for member in &mut table.members {
            member.key.name = member.key.name.replace(MARK, with).into();
            if let Value::Table(inner) = &mut member.node.value {
                rename(Arc::make_mut(inner), with);
            }
        }
    }
    rename(&mut table, with);
    table
}

/// The devices of a description, whatever the rules say that can be switched off.
fn family(document: &Document, sources: &Sources, id: &str) -> Result<Checked<Family>, Diagnostics> {
    let mut diagnostics = Diagnostics::default();
    let members = raw::read(document, id, sources, &mut diagnostics);
    if diagnostics.has_errors() {
        return Err(diagnostics);
    }
    let resolved = resolve::resolve(id, members, &mut diagnostics);
    let mut levels = Levels::default();
    lint::ALL.iter().for_each(|lint| levels.set(lint.rule.name, Level::Allow, None));
    resolved.and_then(|it| check(it, &levels, &[], sources, &mut diagnostics)).ok_or(diagnostics)
}

/// The description with the mark at the end of each text that can be any: those that are left when all are taken out
/// with which there are errors.
fn marked(document: &Document, sources: &Sources) -> (Document, Places) {
    let mut known: BTreeMap<String, Vec<Location>> = BTreeMap::new();
    changed(&document.root, "", &mut |path, text, at| {
        known.entry(path.to_owned()).or_default().push(at);
        text.to_owned()
    });
    let mut free: Places = known.keys().cloned().collect();
    let with = |free: &Places| {
        let mark = |path: &str, text: &str, _| {
            if free.contains(path) { format!("{text} {MARK}") } else { text.to_owned() }
        };
        Document { root: changed(&document.root, "", &mut { mark }), ..document.clone() }
    };
    loop {
        let marked = with(&free);
        let Err(diagnostics) = family(&marked, sources, "device") else { return (marked, free) };
        let wrong: BTreeSet<Location> = diagnostics.iter().filter_map(Diagnostic::at).collect();
        let before = free.len();
        free.retain(|path| !known[path].iter().any(|at| wrong.contains(at)));
        if free.len() == before {
            // what an error elsewhere comes from is found by leaving one out after the other
            let without =
                |path: &String| free.iter().filter(|other| *other != path).cloned().collect::<Places>();
            let fewer = |path: &&String| match family(&with(&without(path)), sources, "device") {
                Err(others) => others.iter().count() < diagnostics.iter().count(),
                Ok(_) => true,
            };
            let path = free.iter().find(fewer).cloned();
            free.remove(&path.unwrap_or_else(|| panic!("no text makes {:?}", diagnostics.iter().next())));
        }
    }
}

/// A description with all that has a name, and one with all that can be said, each with marks in it.
static DESCRIPTIONS: LazyLock<[(&str, Document, Sources); 2]> = LazyLock::new(|| {
    let memory = Memory::new().with("names/device.toml", include_str!("dangerous.toml"));
    let (names, its_sources) = load(&memory, Path::new("names"));
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices/c887");
    let (mut whole, sources) = load(&Disk, &shipped);
    // they quote other texts, which would have to change with them
    whole.root.members.retain(|section| &*section.key.name != "errata");
    let (whole, free) = marked(&whole, &sources);
    assert!(free.len() > 100, "few places take text: {free:?}");
    [("names", names, its_sources), ("c887", whole, sources)]
});

/// The outputs of the descriptions with something in place of each mark, by the name of the description and theirs.
fn outputs(with: &str) -> Vec<(String, String)> {
    let made = DESCRIPTIONS.iter().flat_map(|(name, document, sources)| {
        let document = Document { root: exchanged(&document.root, with), ..document.clone() };
        let family = family(&document, sources, &format!("{name} {with}"));
        let family = family.unwrap_or_else(|it| panic!("{name}: {:?}", it.iter().next()));
        let files = emit(&family, ALL, &Options::default()).0;
        let texts = files.into_iter().filter_map(|(file, bytes)| {
            let (_, end) = file.rsplit_once('.')?;
            if BYTES.contains(&end) {
                return None;
            }
            Some((format!("{name}.{end}"), String::from_utf8(bytes).ok()?))
        });
        texts.collect::<Vec<_>>()
    });
    made.collect()
}

#[test]
fn no_output_holds_a_hazard() {
    for (name, text) in outputs(HAZARDS) {
        let found = text.char_indices().find(|(_, c)| hazard(*c).is_some());
        let around = found.and_then(|(at, _)| text[..at].lines().last());
        assert_eq!(found, None, "{name}, behind {around:?}");
        assert!(text.contains("31m"), "{name} lost what is no hazard");
    }
}

/// How a text begins and ends in C and what has that from C, and what escapes its end.
const C_TEXT: (char, char) = ('"', '\\');

/// What an output consists of, whatever its texts say.
fn skeleton(name: &str, text: &str) -> Vec<String> {
    match name.rsplit('.').next() {
        Some("xml" | "lcec") => elements(text),
        Some("json") => {
            let mut names = Vec::new();
            members(&serde_json::from_str(text).expect("JSON"), &mut names);
            names
        }
        Some("html") => tags(text),
        Some("rs") => tokens(text.parse().expect("Rust")),
        Some("h" | "c") => program(text, ("/*", "*/"), C_TEXT),
        Some("lua") => program(text, ("--", "\n"), C_TEXT),
        Some("py") => program(text, ("#", "\n"), C_TEXT),
        Some("yaml") => program(text, ("#", "\n"), C_TEXT),
        Some("st") => program(text, ("(*", "*)"), ('\'', '$')),
        Some("eds") => sheet(text),
        _ => {
            let mut fenced = false;
            let blocks = text.lines().map(|line| {
                fenced ^= line.starts_with("```");
                if fenced { "code".to_owned() } else { block(line) }
            });
            blocks.collect()
        }
    }
}

fn elements(text: &str) -> Vec<String> {
    let mut reader = quick_xml::Reader::from_str(text);
    let mut found = Vec::new();
    loop {
        match reader.read_event().expect("XML") {
            Event::Start(tag) | Event::Empty(tag) => {
                let attributes = tag.attributes().map(|it| it.expect("an attribute").key.0.to_owned());
                let name = [tag.name().0.to_owned()].into_iter().chain(attributes);
                found.push(name.collect::<Vec<_>>().join(" "));
            }
            Event::Comment(_) | Event::CData(_) | Event::PI(_) => found.push("other".to_owned()),
            Event::Eof => return found,
            _ => {}
        }
    }
}

/// The tags of a page by name, and what else begins with their sign. What cannot be shown as it is typed is plain text instead.
fn tags(text: &str) -> Vec<String> {
    let ends = |c: char| c.is_whitespace() || "<>\"=".contains(c);
    let names = text.split('<').skip(1).filter_map(|tag| tag.split(ends).next());
    names.filter(|name| !name.ends_with("code")).map(str::to_owned).collect()
}

fn members(value: &serde_json::Value, names: &mut Vec<String>) {
    match value {
        serde_json::Value::Object(object) => object.iter().for_each(|(name, value)| {
            names.push(name.clone());
            members(value, names);
        }),
        serde_json::Value::Array(items) => items.iter().for_each(|item| members(item, names)),
        _ => names.push("value".to_owned()),
    }
}

/// The tokens of a file without documentation, which has more lines where a text is longer, and without names.
fn tokens(stream: TokenStream) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for tree in stream {
        match tree {
            TokenTree::Group(group) if group.stream().to_string().starts_with("doc =") => {
                while found.last().is_some_and(|last| last == "#" || last == "!") {
                    found.pop();
                }
            }
            TokenTree::Group(group) => found.extend(tokens(group.stream())),
            // the last comma of a list is only there where the list has lines
            TokenTree::Punct(sign) if sign.as_char() == ',' => {}
            TokenTree::Punct(sign) => found.push(sign.to_string()),
            TokenTree::Ident(_) => found.push("name".to_owned()),
            TokenTree::Literal(_) => found.push("literal".to_owned()),
        }
    }
    found
}

/// What a line of Markdown is: how it begins, how many cells and what tags it has.
fn block(line: &str) -> String {
    if let Some(("", comment)) = line.split_once("<!--") {
        return format!("a comment, {:?}", comment.split_once("-->").map(|(_, rest)| rest));
    }
    let begin = line.trim_start().chars().next().filter(|c| "#|->`<1".contains(*c));
    let plain = line.replace("\\\\", "");
    let count = |sign: &str| plain.matches(sign).count() - plain.matches(&format!("\\{sign}")).count();
    format!("{begin:?} {} cells, {} tags", count("|"), count("<"))
}

#[test]
fn no_text_changes_what_an_output_consists_of() {
    let plain = outputs("Plain");
    for ((name, text), (_, plain)) in outputs(MARKUP).into_iter().zip(plain) {
        let (found, expected) = (skeleton(&name, &text), skeleton(&name, &plain));
        let differs = found.iter().zip(&expected).position(|(found, expected)| found != expected);
        let differs = differs.or((found.len() != expected.len()).then_some(found.len().min(expected.len())));
        if let Some(at) = differs {
            let around = |parts: &[String]| parts[at.saturating_sub(10)..parts.len().min(at + 5)].join(" ");
            panic!("{name} differs at {at}:\n{}\n{}", around(&found), around(&expected));
        }
    }
}
