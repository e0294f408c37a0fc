//! Named tuples with their functions.

use serde::Serialize;

use crate::emit::identifier::{Claimed, camel};
use crate::emit::program::{Field, Image, Kind, Part, Pdo, Program, Selection};

/// The classes of a module.
#[derive(Debug, Serialize)]
pub(super) struct Classes {
    words: Vec<String>,
    records: Vec<Record>,
}

/// A class for a PDO, or for PDOs that are transferred together.
#[derive(Debug, Serialize)]
struct Record {
    class: String,
    constant: String,
    title: String,
    /// The index of a PDO.
    index: Option<u16>,
    bytes: u32,
    members: Vec<Member>,
    /// The format of `struct`, where every field has one.
    format: Option<String>,
    /// Statements that add to `raw`, and expressions of the values in it, where there is no format.
    pack: Vec<String>,
    unpack: Vec<String>,
}

/// A field.
#[derive(Debug, Serialize)]
struct Member {
    name: String,
    annotation: String,
    default: String,
    title: String,
}

/// Names that the template gives to others.
const TAKEN: &[&str] = &["Final", "NamedTuple", "Mode", "Index", "State"];

impl Classes {
    /// One for each word, each PDO and each image.
    pub(super) fn of(program: &Program) -> Self {
        let mut taken = Claimed::with(TAKEN);
        let mut class = |name: &str| {
            let name = camel(name);
            taken.claim(name.clone(), |number| format!("{name}_{number}"))
        };
        let words = program.words.iter().map(|word| class(&word.name)).collect();
        let mut names: Vec<(&str, String)> = Vec::new();
        let mut records = Vec::new();
        for Selection { pdos, images, .. } in &program.selections {
            for it in pdos {
                names.push((&it.global, class(&it.global)));
                records.extend(names.last().map(|(_, class)| pdo(it, class)));
            }
            for it in images {
                records.push(image(it, class(&it.global), &names));
            }
        }
        Self { words, records }
    }
}

fn pdo(of: &Pdo, class: &str) -> Record {
    Record {
        class: class.to_owned(),
        constant: of.global.to_ascii_uppercase(),
        title: of.title.clone(),
        index: Some(of.index),
        bytes: of.bytes,
        members: of.fields.iter().map(member).collect(),
        format: format(of),
        pack: of.fields.iter().map(pack).collect(),
        unpack: of.fields.iter().map(unpack).collect(),
    }
}

fn member(field: &Field) -> Member {
    let (annotation, default) = match field.kind {
        Kind::Bool => ("bool", "False".to_owned()),
        Kind::Int | Kind::Uint => ("int", "0".to_owned()),
        Kind::Real => ("float", "0.0".to_owned()),
        Kind::Bytes => ("bytes", format!("bytes({})", field.bits.div_ceil(8))),
    };
    let unit = field.unit.as_ref().map(|unit| format!(", in {unit}")).unwrap_or_default();
    let title = format!("{}{unit}", field.title);
    Member { name: field.name.clone(), annotation: annotation.to_owned(), default, title }
}

/// The format without alignment, if each field is what `struct` knows.
fn format(of: &Pdo) -> Option<String> {
    let (mut format, mut at) = (String::from("<"), 0);
    for field in &of.fields {
        let gap = field.offset - at;
        if !gap.is_multiple_of(8) {
            return None;
        }
        format.push_str(&"x".repeat(usize::try_from(gap / 8).ok()?));
        format.push_str(&letter(field)?);
        at = field.offset + field.bits;
    }
    let rest = (of.bytes * 8).checked_sub(at).filter(|rest| rest.is_multiple_of(8))?;
    format.push_str(&"x".repeat(usize::try_from(rest / 8).ok()?));
    Some(format)
}

fn letter(field: &Field) -> Option<String> {
    let same = field.width == field.bits;
    Some(match (field.kind, field.bits) {
        (Kind::Int, 8) if same => "b".into(),
        (Kind::Int, 16) if same => "h".into(),
        (Kind::Int, 32) if same => "i".into(),
        (Kind::Int, 64) if same => "q".into(),
        (Kind::Uint, 8) if same => "B".into(),
        (Kind::Uint, 16) if same => "H".into(),
        (Kind::Uint, 32) if same => "I".into(),
        (Kind::Uint, 64) if same => "Q".into(),
        (Kind::Real, 32) => "f".into(),
        (Kind::Real, 64) => "d".into(),
        _ => return None,
    })
}

fn pack(field: &Field) -> String {
    let Field { name, offset, bits, width, .. } = field;
    let value = match field.kind {
        Kind::Bool => format!("int(self.{name})"),
        Kind::Int | Kind::Uint => format!("_put(self.{name}, {width}, {bits}, {})", signed(field)),
        Kind::Real => format!("int.from_bytes(struct.pack(\"{}\", self.{name}), \"little\")", real(field)),
        Kind::Bytes => format!("_put(int.from_bytes(self.{name}, \"little\"), {bits}, {bits}, False)"),
    };
    format!("{value} << {offset}")
}

fn unpack(field: &Field) -> String {
    let Field { offset, bits, width, .. } = field;
    match field.kind {
        Kind::Bool => format!("bool(raw >> {offset} & 1)"),
        Kind::Int | Kind::Uint => format!("_get(raw >> {offset}, {width}, {bits}, {})", signed(field)),
        Kind::Real => format!(
            "struct.unpack(\"{}\", _get(raw >> {offset}, {bits}, {bits}, False).to_bytes({}, \"little\"))[0]",
            real(field),
            bits / 8
        ),
        Kind::Bytes => {
            format!("_get(raw >> {offset}, {bits}, {bits}, False).to_bytes({}, \"little\")", bits.div_ceil(8))
        }
    }
}

fn signed(field: &Field) -> &'static str {
    if field.kind == Kind::Int { "True" } else { "False" }
}

fn real(field: &Field) -> &'static str {
    if field.bits == 32 { "<f" } else { "<d" }
}

/// The PDOs by their own functions, each shifted to its place.
fn image(of: &Image, class: String, names: &[(&str, String)]) -> Record {
    let named = of.parts.iter().filter_map(|part| {
        let class = names.iter().rev().find(|(global, _)| *global == part.pdo.global)?;
        Some((part, &class.1))
    });
    let member = |(part, class): (&Part, &String)| Member {
        name: part.name.clone(),
        annotation: class.clone(),
        default: format!("{class}()"),
        title: part.pdo.title.clone(),
    };
    let way = if of.is_output { "What the master sends" } else { "What the device sends" };
    Record {
        class,
        constant: of.global.to_ascii_uppercase(),
        title: format!("{way}, {} PDOs", of.parts.len()),
        index: None,
        bytes: of.bytes,
        members: named.clone().map(member).collect(),
        format: None,
        pack: of
            .parts
            .iter()
            .map(|part| format!("int.from_bytes(self.{}.pack(), \"little\") << {}", part.name, part.offset))
            .collect(),
        unpack: named
            .map(|(part, class)| {
                let (bits, bytes) = (part.pdo.bits, part.pdo.bytes);
                let raw = format!("_get(raw >> {}, {bits}, {bits}, False)", part.offset);
                format!("{class}.unpack({raw}.to_bytes({bytes}, \"little\"))")
            })
            .collect(),
    }
}
