//! Structs of C with their functions.

use serde::Serialize;

use super::packing::{Placed, declared, pack, unpack};
use crate::emit::program::{Field, Image, Pdo, Program, Selection};

/// A struct for a PDO, or for PDOs that are transferred together.
#[derive(Debug, Serialize)]
pub(super) struct Record {
    global: String,
    title: String,
    /// The index of a PDO.
    index: Option<u16>,
    bytes: u32,
    members: Vec<Member>,
    pack: Vec<String>,
    unpack: Vec<String>,
}

/// A member of a struct.
#[derive(Debug, Serialize)]
struct Member {
    declaration: String,
    title: String,
}

/// All of a program, each behind those that it is made of.
pub(super) fn records(program: &Program) -> Vec<Record> {
    let of = |Selection { pdos, images, .. }: &Selection| -> Vec<Record> {
        pdos.iter().map(pdo).chain(images.iter().map(|it| image(&program.prefix, it))).collect()
    };
    program.selections.iter().flat_map(of).collect()
}

fn pdo(of: &Pdo) -> Record {
    let places: Vec<Placed<'_>> =
        of.fields.iter().map(|field| Placed { path: String::new(), field, at: field.offset }).collect();
    Record {
        global: of.global.clone(),
        title: of.title.clone(),
        index: Some(of.index),
        bytes: of.bytes,
        members: of.fields.iter().map(member).collect(),
        pack: pack(&places, of.bytes),
        unpack: unpack(&places),
    }
}

fn member(field: &Field) -> Member {
    let (in_front, behind) = declared(field);
    let unit = field.unit.as_ref().map(|unit| format!(", in {unit}")).unwrap_or_default();
    Member {
        declaration: format!("{in_front} {}{behind}", field.name),
        title: format!("{}{unit}", field.title),
    }
}

fn image(prefix: &str, of: &Image) -> Record {
    let parts = of.parts.iter().filter(|part| !part.pdo.fields.is_empty());
    let places = parts.clone().flat_map(|part| {
        let path = format!("{}.", part.name);
        part.pdo.fields.iter().map(move |field| Placed {
            path: path.clone(),
            field,
            at: part.offset + field.offset,
        })
    });
    let places: Vec<Placed<'_>> = places.collect();
    let way = if of.is_output { "What the master sends" } else { "What the device sends" };
    Record {
        global: of.global.clone(),
        title: format!("{way}, {} PDOs", of.parts.len()),
        index: None,
        bytes: of.bytes,
        members: parts
            .map(|part| Member {
                declaration: format!("struct {prefix}_{} {}", part.pdo.global, part.name),
                title: part.pdo.title.clone(),
            })
            .collect(),
        pack: pack(&places, of.bytes),
        unpack: unpack(&places),
    }
}
