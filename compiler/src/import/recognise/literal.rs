//! Defaults and limits in the type they are for.

use super::super::read::{Written, number};
use super::super::toml::Toml;
use crate::model::DataType;

/// A value as a description writes it, or why it cannot.
pub(super) fn literal(written: &Written, data_type: DataType) -> Result<Toml, &'static str> {
    match (written, data_type) {
        (Written::Data(bytes), DataType::Text(length)) => text(bytes, length),
        (Written::Text(words), DataType::Text(length)) => text(words.as_bytes(), length),
        (Written::Number(digits), DataType::Text(length)) => text(digits.as_bytes(), length),
        (Written::Data(bytes), DataType::Octets(length)) => octets(bytes, length),
        (Written::Text(words), DataType::Octets(length)) => octets(words.as_bytes(), length),
        (Written::Number(words), DataType::Octets(length)) => {
            let number = number::<u64>(words).ok_or("it is neither bytes nor a number")?;
            octets(&number.to_le_bytes(), length)
        }
        (Written::Data(bytes), _) => of_bytes(bytes, data_type),
        (Written::Number(words) | Written::Text(words), DataType::Real32 | DataType::Real64) => {
            if let Some(bits) = bits_of_real(written, data_type) {
                return of_bytes(&bits.to_le_bytes(), data_type);
            }
            let value = words.trim().parse::<f64>().ok().or_else(|| number::<i64>(words).map(|it| it as f64));
            value.filter(|value| value.is_finite()).map(Toml::Real).ok_or("it is no number")
        }
        (Written::Number(words) | Written::Text(words), _) => {
            let truth = match words.trim() {
                "true" => Some(1),
                "false" => Some(0),
                _ => None,
            };
            let value = truth.or_else(|| number::<i128>(words)).ok_or_else(|| no_number(words))?;
            integer(value, data_type)
        }
    }
}

/// Why words are no number: in an EDS some depend on the number that a node has on its CAN.
fn no_number(words: &str) -> &'static str {
    match words.to_ascii_uppercase().contains("$NODEID") {
        true => "it depends on the number of a node of CANopen",
        false => "it is no whole number",
    }
}

/// The bits of a number of 32 bits that are written as a whole number: one so large is none that the type could hold
/// exactly.
pub(super) fn bits_of_real(written: &Written, data_type: DataType) -> Option<u32> {
    match written {
        Written::Number(words) if data_type == DataType::Real32 => {
            number::<u32>(words).filter(|bits| *bits > 1 << 24)
        }
        _ => None,
    }
}

fn text(bytes: &[u8], length: u16) -> Result<Toml, &'static str> {
    let end = bytes.iter().rposition(|byte| *byte != 0).map_or(0, |place| place + 1);
    let text =
        bytes.get(..end).and_then(|bytes| std::str::from_utf8(bytes).ok()).ok_or("its bytes are no text")?;
    if text.chars().any(char::is_control) {
        return Err("it has characters that cannot be printed");
    }
    if text.len() > usize::from(length) {
        return Err("the text is longer than its type");
    }
    Ok(Toml::text(text))
}

/// Bytes as they are, in pairs; zeros at the end say nothing.
fn octets(bytes: &[u8], length: u16) -> Result<Toml, &'static str> {
    let end = bytes.iter().rposition(|byte| *byte != 0).map_or(0, |place| place + 1);
    if end > usize::from(length) {
        return Err("it has more bytes than its type");
    }
    Ok(Toml::text(pairs(bytes.get(..end.max(1)).unwrap_or(&[0]))))
}

/// Bytes in groups of two.
pub(super) fn pairs(bytes: &[u8]) -> String {
    let words = bytes.chunks(2).map(|pair| pair.iter().map(|byte| format!("{byte:02X}")).collect::<String>());
    words.collect::<Vec<_>>().join(" ")
}

/// A value from little-endian bytes: missing ones are zeros, and zeros beyond the type do not count.
fn of_bytes(bytes: &[u8], data_type: DataType) -> Result<Toml, &'static str> {
    let width = usize::try_from(data_type.bytes()).unwrap_or(usize::MAX);
    let (inside, beyond) = bytes.split_at(bytes.len().min(width));
    if beyond.iter().any(|byte| *byte != 0) {
        return Err("it has more bytes than its type");
    }
    let raw = inside.iter().rev().fold(0_u64, |value, byte| value << 8 | u64::from(*byte));
    match data_type {
        DataType::Real32 => {
            let value = f32::from_bits(u32::try_from(raw).unwrap_or(0));
            let shortest = value.is_finite().then(|| value.to_string().parse().ok()).flatten();
            shortest.map(Toml::Real).ok_or("it is no number")
        }
        DataType::Real64 => {
            let value = f64::from_bits(raw);
            value.is_finite().then_some(Toml::Real(value)).ok_or("it is no number")
        }
        DataType::Int(bits) if inside.len() == width => {
            let shift = 64_u32.saturating_sub(bits.into());
            integer(i128::from((raw << shift).cast_signed() >> shift), data_type)
        }
        _ => integer(raw.into(), data_type),
    }
}

fn integer(value: i128, data_type: DataType) -> Result<Toml, &'static str> {
    let fits = data_type.range().is_some_and(|(min, max)| (min..=max).contains(&value));
    let value = match data_type {
        // Some write the bits of a negative number.
        DataType::Int(bits) if !fits && value > 0 => value.checked_sub(1_i128 << bits).unwrap_or(value),
        _ => value,
    };
    let (min, max) = data_type.range().ok_or("it is no number")?;
    if !(min..=max).contains(&value) {
        return Err("it does not fit its type");
    }
    Ok(match data_type {
        DataType::Bool => Toml::Bool(value == 1),
        // As people know it: all bits.
        DataType::Uint(32) if value == 0xFFFF_FFFF => hex(value, 8),
        DataType::Bitstring(bits) => hex(value, usize::from(bits / 4)),
        _ => Toml::Integer(value),
    })
}

fn hex(value: i128, digits: usize) -> Toml {
    u64::try_from(value).map_or(Toml::Integer(value), |value| Toml::Hex(value, digits))
}
