//! Fields to bytes and back as statements of C.
//!
//! Every byte is put together of shifted parts, so that neither the order of bytes nor alignment matter, and casts say
//! each change of type, so that no compiler has to.

use crate::emit::program::{Field, Kind, Piece, pieces};

/// A field in an image.
pub(super) struct Placed<'p> {
    /// How it is reached from the struct: empty, or `rx_1600.`.
    pub(super) path: String,
    pub(super) field: &'p Field,
    /// Its first bit.
    pub(super) at: u32,
}

/// The type of a member, in front of its name and behind it.
pub(super) fn declared(field: &Field) -> (String, String) {
    let width = storage(field);
    match field.kind {
        Kind::Bool => ("uint8_t".to_owned(), String::new()),
        Kind::Int => (format!("int{width}_t"), String::new()),
        Kind::Uint => (format!("uint{width}_t"), String::new()),
        Kind::Real if width == 32 => ("float".to_owned(), String::new()),
        Kind::Real => ("double".to_owned(), String::new()),
        Kind::Bytes => ("uint8_t".to_owned(), format!("[{}]", field.bits.div_ceil(8))),
    }
}

/// The width of the type that holds a value.
fn storage(field: &Field) -> u32 {
    field.width.next_power_of_two().max(8)
}

/// The width of the number in which its bits are shifted.
fn container(bits: u32) -> u32 {
    if bits > 32 { 64 } else { 32 }
}

/// The statements that fill `to` from `from`.
pub(super) fn pack(fields: &[Placed<'_>], bytes: u32) -> Vec<String> {
    let mut lines = Vec::new();
    let mut parts: Vec<Vec<String>> = vec![Vec::new(); usize::try_from(bytes).unwrap_or(0)];
    for (number, placed) in fields.iter().enumerate() {
        let (field, member) = (placed.field, format!("from->{}{}", placed.path, placed.field.name));
        let width = container(field.bits);
        let raw = match field.kind {
            Kind::Bool => format!("(uint32_t)({member} != 0)"),
            Kind::Int | Kind::Uint => format!("(uint{width}_t){member}"),
            Kind::Real => {
                lines.push(format!("uint{width}_t raw{number};"));
                lines.push(format!("memcpy(&raw{number}, &{member}, sizeof raw{number});"));
                format!("raw{number}")
            }
            Kind::Bytes => {
                for (byte, at, bits) in split(placed) {
                    add(&mut parts, &format!("(uint32_t){member}[{byte}]"), at, bits);
                }
                continue;
            }
        };
        add(&mut parts, &raw, placed.at, field.bits);
    }
    // declarations before statements
    lines.sort_by_key(|line| line.starts_with("memcpy"));
    lines.extend(parts.iter().enumerate().map(|(byte, parts)| match parts.as_slice() {
        [] => format!("to[{byte}] = 0u;"),
        parts => format!("to[{byte}] = (uint8_t)({});", parts.join(" | ")),
    }));
    lines
}

/// Each byte of a value that is bytes: its number, its first bit in the image, and how many it has.
fn split(placed: &Placed<'_>) -> impl Iterator<Item = (u32, u32, u32)> {
    let (at, bits) = (placed.at, placed.field.bits);
    (0..bits.div_ceil(8)).map(move |byte| (byte, at + byte * 8, (bits - byte * 8).min(8)))
}

/// Adds the bits of a value to the bytes that they are in.
fn add(parts: &mut [Vec<String>], raw: &str, at: u32, bits: u32) {
    for piece in pieces(at, bits) {
        let Some(part) = usize::try_from(piece.byte).ok().and_then(|byte| parts.get_mut(byte)) else {
            continue;
        };
        let shifted = match piece.in_value {
            0 => raw.to_owned(),
            by => format!("({raw} >> {by})"),
        };
        let masked = format!("({shifted} & 0x{:02X}u)", piece.mask());
        part.push(match piece.in_byte {
            0 => masked,
            by => format!("({masked} << {by})"),
        });
    }
}

/// The statements that fill `to` from the bytes of `from`.
pub(super) fn unpack(fields: &[Placed<'_>]) -> Vec<String> {
    fields.iter().flat_map(unpack_one).collect()
}

fn unpack_one(placed: &Placed<'_>) -> Vec<String> {
    let (field, member) = (placed.field, format!("to->{}{}", placed.path, placed.field.name));
    let width = container(field.bits);
    let joined = joined(placed.at, field.bits);
    let (declared, _) = declared(field);
    match field.kind {
        Kind::Bool | Kind::Uint => vec![format!("{member} = ({declared})({joined});")],
        Kind::Int if field.bits >= storage(field) || field.bits == width => {
            vec![format!("{member} = ({declared})({joined});")]
        }
        Kind::Int => {
            let sign = number(1_u64 << field.bits.saturating_sub(1), width);
            vec![format!("{member} = ({declared})((({joined}) ^ {sign}) - {sign});")]
        }
        Kind::Real => {
            vec![format!("{{ const uint{width}_t raw = {joined}; memcpy(&{member}, &raw, sizeof raw); }}")]
        }
        Kind::Bytes => {
            let bytes = split(placed)
                .map(|(byte, at, bits)| format!("{member}[{byte}] = (uint8_t)({});", self::joined(at, bits)));
            bytes.collect()
        }
    }
}

fn number(value: u64, width: u32) -> String {
    if width > 32 { format!("0x{value:X}ull") } else { format!("0x{value:X}u") }
}

/// A value put together of its bytes.
fn joined(at: u32, bits: u32) -> String {
    let part = |piece: Piece| {
        let byte = format!("(uint{}_t)from[{}]", container(bits), piece.byte);
        let shifted = match piece.in_byte {
            0 => byte,
            by => format!("({byte} >> {by})"),
        };
        let masked = match piece.in_byte + piece.bits {
            8 => shifted,
            _ => format!("({shifted} & 0x{:02X}u)", piece.mask()),
        };
        match piece.in_value {
            0 => masked,
            by => format!("({masked} << {by})"),
        }
    };
    pieces(at, bits).map(part).collect::<Vec<_>>().join(" | ")
}
