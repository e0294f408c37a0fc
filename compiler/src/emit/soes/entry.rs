//! Objects as rows of the table, and what of them lies in the memory of a firmware.

use serde::Serialize;

use crate::emit::identifier::Claimed;
use crate::emit::program::Object as Named;
use crate::lint::rules::overlong_value;
use crate::model::{Access, DataType, Entry as Described, Kind, Object as DescribedObject, Value};

/// An object.
#[derive(Debug, Serialize)]
pub(super) struct Object {
    index: u16,
    /// The name of its kind in the stack.
    kind: &'static str,
    highest: u8,
    title: String,
    /// The member of the struct that its values are in.
    member: String,
    /// Whether it is one value, without a struct of its own.
    is_single: bool,
    /// One for each subindex up to the highest, so that the place in the table is the subindex, as the stack takes it to be.
    rows: Vec<Row>,
}

/// A row of the table.
#[derive(Debug, Default, Serialize)]
struct Row {
    subindex: u8,
    /// The name of its type in the stack, or the number where it has none; 0 where there is no such subindex.
    data_type: String,
    bits: u32,
    flags: String,
    title: String,
    /// What a value of at most 32 bits is at the start.
    value: u32,
    data: Option<Data>,
}

/// A value in the memory of the firmware.
#[derive(Debug, Serialize)]
struct Data {
    /// How it is reached from the struct of all.
    path: String,
    declaration: String,
    /// What it is at the start, as C writes it.
    initial: String,
}

impl Object {
    /// Whether some value of it lies in memory.
    pub(super) fn has_values(&self) -> bool {
        self.rows.iter().any(|row| row.data.is_some())
    }
}

/// An object with its rows; `named` has the names that C takes.
pub(super) fn object(of: &DescribedObject, named: &Named, taken: &mut Claimed) -> Object {
    let member = taken.claim(named.name.clone(), |number| format!("{}_{number}", named.name));
    let own: Vec<&str> = named.entries.iter().map(|entry| entry.name.as_str()).collect();
    let mut others = Claimed::with(&own);
    let rows = (0..=of.highest_subindex()).map(|subindex| {
        let held = of.entry(subindex).filter(|entry| entry.data_type.bits() <= overlong_value::MOST_BITS);
        let Some(entry) = held else { return Row { subindex, ..Row::default() } };
        let name = named.entries.iter().find(|entry| entry.subindex == subindex);
        let name = name.map(|entry| entry.name.clone()).unwrap_or_else(|| {
            let name = format!("sub_{subindex:02x}");
            others.claim(name.clone(), |number| format!("{name}_{number}"))
        });
        row(of, entry, (of.kind != Kind::Var).then_some(name), &member)
    });
    let rows = rows.collect();
    Object {
        index: of.index.0,
        kind: match of.kind {
            Kind::Var => "OTYPE_VAR",
            Kind::Array => "OTYPE_ARRAY",
            Kind::Record => "OTYPE_RECORD",
        },
        highest: of.highest_subindex(),
        title: named.title.clone(),
        member,
        is_single: of.kind == Kind::Var,
        rows,
    }
}

/// A row; `name` is that of the value within its object, if that has a struct of its own.
fn row(object: &DescribedObject, entry: &Described, name: Option<String>, member: &str) -> Row {
    let bytes = match &entry.default {
        Some(value) => value.little_endian(entry.data_type),
        None => vec![0; usize::try_from(entry.data_type.bytes()).unwrap_or(0)],
    };
    let low = || bytes.iter().take(4).rev().fold(0, |value, byte| (value << 8) | u32::from(*byte));
    let data = is_in_memory(object, entry).then(|| {
        let path = name.as_ref().map_or(member.to_owned(), |name| format!("{member}.{name}"));
        let (kind, length) = declared(entry.data_type);
        let length = length.map(|length| format!("[{length}]")).unwrap_or_default();
        let declaration = format!("{kind} {}{length}", name.as_deref().unwrap_or(member));
        Data { path, declaration, initial: initial(entry, &bytes) }
    });
    Row {
        subindex: entry.address.subindex,
        data_type: data_type(entry.data_type),
        bits: entry.data_type.bits(),
        flags: flags(entry),
        title: crate::emit::escape::prose(&entry.name),
        value: if entry.data_type.bits() <= 32 { low() } else { 0 },
        data,
    }
}

/// What only the table knows are counts, what follows from the process data, and numbers that never change. All that is
/// longer than a value of the table has to lie elsewhere.
fn is_in_memory(object: &DescribedObject, entry: &Described) -> bool {
    if entry.access.writable() || entry.data_type.bits() > 32 || entry.pdo.rx() || entry.pdo.tx() {
        return true;
    }
    let is_count = object.kind != Kind::Var && entry.address.subindex == 0;
    !(is_count || object.derived || entry.access == Access::Const)
}

fn data_type(of: DataType) -> String {
    match of {
        DataType::Bool => "DTYPE_BOOLEAN".to_owned(),
        DataType::Int(bits @ (8 | 16 | 24 | 32 | 64)) => format!("DTYPE_INTEGER{bits}"),
        // the stack copies no BYTE, WORD or DWORD into process data: they are the numbers of their width
        DataType::Uint(bits @ (8 | 16 | 24 | 32 | 64)) | DataType::Bitstring(bits) => {
            format!("DTYPE_UNSIGNED{bits}")
        }
        DataType::Real32 => "DTYPE_REAL32".to_owned(),
        DataType::Real64 => "DTYPE_REAL64".to_owned(),
        DataType::Bits(bits) => format!("DTYPE_BIT{bits}"),
        DataType::Text(_) => "DTYPE_VISIBLE_STRING".to_owned(),
        DataType::Octets(_) => "DTYPE_OCTET_STRING".to_owned(),
        DataType::Unicode(_) => "DTYPE_UNICODE_STRING".to_owned(),
        DataType::Int(_) | DataType::Uint(_) | DataType::Array(..) => format!("0x{:04X}", of.code()),
    }
}

/// The type in C, and how many of them there are. What C has no number for are bytes as they travel.
fn declared(of: DataType) -> (String, Option<u32>) {
    match of {
        DataType::Bool | DataType::Bits(_) => ("uint8_t".to_owned(), None),
        DataType::Int(bits @ (8 | 16 | 32 | 64)) => (format!("int{bits}_t"), None),
        DataType::Uint(bits @ (8 | 16 | 32 | 64)) | DataType::Bitstring(bits) => {
            (format!("uint{bits}_t"), None)
        }
        DataType::Real32 => ("float".to_owned(), None),
        DataType::Real64 => ("double".to_owned(), None),
        _ => ("uint8_t".to_owned(), Some(of.bytes().max(1))),
    }
}

/// The value at the start, as C writes it.
fn initial(entry: &Described, bytes: &[u8]) -> String {
    if declared(entry.data_type).1.is_some() {
        let bytes: Vec<String> = bytes.iter().map(|byte| format!("0x{byte:02X}")).collect();
        return format!("{{ {} }}", if bytes.is_empty() { "0".to_owned() } else { bytes.join(", ") });
    }
    let value = entry.default.as_ref();
    match entry.data_type {
        DataType::Real32 => format!("{:?}f", value.and_then(Value::real).unwrap_or_default() as f32),
        DataType::Real64 => format!("{:?}", value.and_then(Value::real).unwrap_or_default()),
        _ => match value.and_then(Value::integer).unwrap_or_default() {
            // C has no literal for it: the sign is an operator
            least if least == i64::MIN.into() => "-0x7FFFFFFFFFFFFFFFll - 1".to_owned(),
            number if number > i64::MAX.into() => format!("{number}ull"),
            number if i32::try_from(number).is_err() => format!("{number}ll"),
            number => number.to_string(),
        },
    }
}

/// Who may do what in which state.
fn flags(entry: &Described) -> String {
    let mut flags = Vec::new();
    let window = entry.written.map(|window| window.states()).filter(|_| entry.access.writable());
    match (entry.access, window) {
        (Access::Rw, None) => flags.push("ATYPE_RW"),
        (Access::Wo, None) => flags.push("ATYPE_WO"),
        (Access::Wo, Some(_)) => {}
        (Access::Ro | Access::Const | Access::Rw, _) => flags.push("ATYPE_RO"),
    }
    let states = ["ATYPE_Wpre", "ATYPE_Wsafe", "ATYPE_Wop"].into_iter().zip(window.unwrap_or_default());
    flags.extend(states.filter_map(|(flag, may)| may.then_some(flag)));
    let others = [
        ("ATYPE_RXPDO", entry.pdo.rx()),
        ("ATYPE_TXPDO", entry.pdo.tx()),
        ("ATYPE_BACKUP", entry.backup),
        ("ATYPE_SETTING", entry.setting),
    ];
    flags.extend(others.into_iter().filter_map(|(flag, is_so)| is_so.then_some(flag)));
    flags.join(" | ")
}
