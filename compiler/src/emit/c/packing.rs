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

/// A byte of an image: what is read before it can be put together, and its parts.
#[derive(Clone, Default)]
struct Byte {
    reads: Vec<String>,
    parts: Vec<String>,
}

/// The statements that fill `to` from `from`. Each value is read once, where its first byte comes: for all the compiler knows,
/// a byte that is written could be one of the struct, and the value would have to be read again behind it.
pub(super) fn pack(fields: &[Placed<'_>], bytes: u32) -> Vec<String> {
    let mut image = vec![Byte::default(); usize::try_from(bytes).unwrap_or(0)];
    for (number, placed) in fields.iter().enumerate() {
        let (field, member) = (placed.field, format!("from->{}{}", placed.path, placed.field.name));
        let (width, raw) = (container(field.bits), format!("raw{number}"));
        let reads = match field.kind {
            Kind::Bool => vec![format!("const uint32_t {raw} = (uint32_t)({member} != 0);")],
            Kind::Int | Kind::Uint => vec![format!("const uint{width}_t {raw} = (uint{width}_t){member};")],
            Kind::Real => {
                let copied = format!("memcpy(&{raw}, &{member}, sizeof {raw});");
                vec![format!("uint{width}_t {raw};"), copied]
            }
            Kind::Bytes => {
                for (byte, at, bits) in split(placed) {
                    add(&mut image, &format!("(uint32_t){member}[{byte}]"), at, bits);
                }
                continue;
            }
        };
        let first = usize::try_from(placed.at / 8).ok().and_then(|byte| image.get_mut(byte));
        first.into_iter().for_each(|byte| byte.reads.extend_from_slice(&reads));
        add(&mut image, &raw, placed.at, field.bits);
    }
    let lines = image.into_iter().enumerate().flat_map(|(number, Byte { mut reads, parts })| {
        reads.push(match parts.as_slice() {
            [] => format!("to[{number}] = 0u;"),
            parts => format!("to[{number}] = (uint8_t)({});", parts.join(" | ")),
        });
        reads
    });
    lines.collect()
}

/// Each byte of a value that is bytes: its number, its first bit in the image, and how many it has.
fn split(placed: &Placed<'_>) -> impl Iterator<Item = (u32, u32, u32)> {
    let (at, bits) = (placed.at, placed.field.bits);
    (0..bits.div_ceil(8)).map(move |byte| (byte, at + byte * 8, (bits - byte * 8).min(8)))
}

/// Adds the bits of a value to the bytes that they are in.
fn add(image: &mut [Byte], raw: &str, at: u32, bits: u32) {
    for piece in pieces(at, bits) {
        let Some(byte) = usize::try_from(piece.byte).ok().and_then(|byte| image.get_mut(byte)) else {
            continue;
        };
        let shifted = match piece.in_value {
            0 => raw.to_owned(),
            by => format!("({raw} >> {by})"),
        };
        let masked = format!("({shifted} & 0x{:02X}u)", piece.mask());
        byte.parts.push(match piece.in_byte {
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
