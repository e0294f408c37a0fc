//! PDOs as structs whose fields lie as the bytes travel.

use serde::Serialize;

use super::text::KEYWORDS;
use crate::emit::identifier::Claimed;
use crate::emit::program::{Field, Kind, Pdo};

/// A struct.
#[derive(Debug, Serialize)]
pub(super) struct Record {
    global: String,
    index: u16,
    title: String,
    bytes: u32,
    members: Vec<Member>,
}

/// A field of a struct.
#[derive(Debug, Serialize)]
struct Member {
    name: String,
    kind: String,
    /// What is in it, a line each.
    titles: Vec<String>,
}

/// Fields that share bytes with one another and with no other, and the bytes.
struct Cluster<'p> {
    first: u32,
    end: u32,
    fields: Vec<&'p Field>,
}

/// A PDO without a gap between its members.
pub(super) fn record(pdo: &Pdo) -> Record {
    let mut names = Claimed::default();
    let (mut members, mut at) = (Vec::new(), 0);
    for cluster in clusters(&pdo.fields) {
        members.extend(gap(at, cluster.first, &mut names));
        members.push(member(&cluster, &mut names));
        at = cluster.end;
    }
    members.extend(gap(at, pdo.bytes, &mut names));
    Record {
        global: pdo.global.clone(),
        index: pdo.index,
        title: pdo.title.clone(),
        bytes: pdo.bytes,
        members,
    }
}

fn clusters(fields: &[Field]) -> Vec<Cluster<'_>> {
    let mut clusters: Vec<Cluster<'_>> = Vec::new();
    for field in fields {
        let (first, end) = (field.offset / 8, (field.offset + field.bits).div_ceil(8));
        match clusters.last_mut().filter(|last| first < last.end) {
            Some(last) => {
                last.end = last.end.max(end);
                last.fields.push(field);
            }
            None => clusters.push(Cluster { first, end, fields: vec![field] }),
        }
    }
    clusters
}

fn gap(from: u32, to: u32, names: &mut Claimed) -> Option<Member> {
    let bytes = to.checked_sub(from).filter(|bytes| *bytes > 0)?;
    let name = claim(&format!("reserved_{from}"), names);
    Some(Member { name, kind: array(bytes), titles: vec!["nothing".to_owned()] })
}

fn member(cluster: &Cluster<'_>, names: &mut Claimed) -> Member {
    let bytes = cluster.end - cluster.first;
    match cluster.fields.as_slice() {
        [field] if field.bits == bytes * 8 => {
            let unit = field.unit.as_ref().map(|unit| format!(", in {unit}")).unwrap_or_default();
            let titles = vec![format!("{}{unit}", field.title)];
            Member {
                name: claim(&field.name, names),
                kind: number(field).unwrap_or_else(|| array(bytes)),
                titles,
            }
        }
        fields => {
            let title = |field: &&Field| {
                let low = field.offset - cluster.first * 8;
                format!("bits {low} to {}: {}", low + field.bits - 1, field.title)
            };
            let name = match fields {
                [field] => field.name.clone(),
                _ => format!("bits_{}", cluster.first),
            };
            let kind = if bytes == 1 { "BYTE".to_owned() } else { array(bytes) };
            Member { name: claim(&name, names), kind, titles: fields.iter().map(title).collect() }
        }
    }
}

/// The type of a field that has all bits of its bytes, if the language has one.
fn number(field: &Field) -> Option<String> {
    if field.width != field.bits {
        return None;
    }
    let name = match (field.kind, field.bits) {
        (Kind::Int, 8) => "SINT",
        (Kind::Int, 16) => "INT",
        (Kind::Int, 32) => "DINT",
        (Kind::Int, 64) => "LINT",
        (Kind::Uint, 8) => "USINT",
        (Kind::Uint, 16) => "UINT",
        (Kind::Uint, 32) => "UDINT",
        (Kind::Uint, 64) => "ULINT",
        (Kind::Real, 32) => "REAL",
        (Kind::Real, 64) => "LREAL",
        _ => return None,
    };
    Some(name.to_owned())
}

fn array(bytes: u32) -> String {
    format!("ARRAY[0..{}] OF BYTE", bytes.saturating_sub(1))
}

/// A name that is no keyword, in whatever case; the standard takes no underscore at an end.
fn claim(name: &str, names: &mut Claimed) -> String {
    let is_keyword = KEYWORDS.iter().any(|word| name.eq_ignore_ascii_case(word));
    let name = if is_keyword { format!("v_{name}") } else { name.to_owned() };
    names.claim(name.clone(), |number| format!("{name}_{number}"))
}
