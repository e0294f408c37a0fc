//! What bytes on the wire say: process data, emergencies and messages.

use super::bits::word;
use super::layout::{columns, paragraph};
use crate::model::{DataType, Device, ErrorCode, Field, Index, Mapped, Pdo, Source, Telegram};

/// What people call an emergency.
const EMERGENCY: [&str; 2] = ["emcy", "emergency"];

/// The object whose bits the third byte of an emergency are, CiA 301.
const ERROR_REGISTER: Index = Index(0x1001);

/// Tells what bytes mean for a device: those of a PDO, called by its index or its name, those of an emergency (`emcy`), or
/// those of one of its telegrams. None if the device has no such thing.
pub fn bytes(device: &Device, what: &str, bytes: &[u8]) -> Option<String> {
    if EMERGENCY.iter().any(|word| what.eq_ignore_ascii_case(word)) {
        return emergency(device, bytes);
    }
    if let Some(pdo) = pdo(device, what) {
        return Some(process_data(device, pdo, bytes));
    }
    let telegram =
        device.telegrams.iter().find(|it| [&it.id, &it.name].iter().any(|name| is_called(name, what)))?;
    Some(message(device, telegram, bytes))
}

fn pdo<'d>(device: &'d Device, what: &str) -> Option<&'d Pdo> {
    let index = what.strip_prefix("0x").or(what.strip_prefix("0X"));
    match index.and_then(|digits| u16::from_str_radix(digits, 16).ok()) {
        Some(index) => device.pdo(Index(index)),
        None => device.pdos.iter().find(|pdo| is_called(&device.on_axis(&pdo.name, pdo.axis), what)),
    }
}

fn is_called(name: &str, what: &str) -> bool {
    super::word::plain(name) == super::word::plain(what)
}

/// Each field with its place and its value; then the words whose bits have names.
fn process_data(device: &Device, pdo: &Pdo, bytes: &[u8]) -> String {
    let name = device.on_axis(&pdo.name, pdo.axis);
    let length = usize::try_from(pdo.bytes()).unwrap_or(usize::MAX);
    let mut parts = vec![format!("PDO {} of {}: {name}, {length} bytes", pdo.index, device.name)];
    if bytes.len() != length {
        parts.push(format!("There are {} bytes: is it mapped otherwise?", bytes.len()));
    }
    let rows: Vec<Vec<String>> = pdo.entries.iter().map(|mapped| field(device, pdo, mapped, bytes)).collect();
    parts.push(columns(&rows).join("\n"));
    let words = pdo.entries.iter().filter_map(|mapped| {
        let raw = raw(bytes, mapped.offset, mapped.bits)?;
        word(device, &word_of(device, mapped)?, raw)
    });
    parts.extend(words);
    parts.extend(pdo.source.as_ref().map(said_by));
    parts.join("\n\n")
}

fn said_by(source: &Source) -> String {
    format!("  source  {source}")
}

/// A field: its bytes or bits, what is mapped, its name and its value.
fn field(device: &Device, pdo: &Pdo, mapped: &Mapped, bytes: &[u8]) -> Vec<String> {
    let address = mapped.address.map_or(String::new(), |address| address.to_string());
    let value = match raw(bytes, mapped.offset, mapped.bits) {
        Some(raw) => value(device, pdo, mapped, raw),
        None => text(bytes, mapped).unwrap_or_else(|| "missing".to_owned()),
    };
    vec![place(mapped.offset, mapped.bits), address, mapped.name.clone(), value]
}

fn place(offset: u32, bits: u32) -> String {
    let last = offset.saturating_add(bits).saturating_sub(1);
    match (offset.is_multiple_of(8) && bits.is_multiple_of(8), offset / 8, last / 8) {
        (true, first, last) if first == last => format!("byte {first}"),
        (true, first, last) => format!("bytes {first} to {last}"),
        (false, first, _) if bits == 1 => format!("byte {first}, bit {}", offset % 8),
        (false, first, _) => format!("byte {first}, bits {} to {}", offset % 8, (offset % 8) + bits - 1),
    }
}

/// Bits as a number, the lowest first; none if there are fewer, or more than a number has.
fn raw(bytes: &[u8], offset: u32, bits: u32) -> Option<u64> {
    if bits == 0 || bits > 64 {
        return None;
    }
    let bit = |place: u32| {
        let byte = bytes.get(usize::try_from(place / 8).ok()?)?;
        Some(u64::from(byte >> (place % 8) & 1))
    };
    (0..bits).try_fold(0, |value, place| Some(value | bit(offset.checked_add(place)?)? << place))
}

/// The text of a field that is too long for a number.
fn text(bytes: &[u8], mapped: &Mapped) -> Option<String> {
    let first = usize::try_from(mapped.offset / 8).ok()?;
    let length = usize::try_from(mapped.bits / 8).ok()?;
    let bytes = bytes.get(first..first.checked_add(length)?)?;
    match mapped.data_type {
        Some(DataType::Text(_)) => {
            Some(format!("{:?}", String::from_utf8_lossy(bytes).trim_end_matches('\0')))
        }
        _ => Some(hex(bytes)),
    }
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" ")
}

/// The value with its unit, or what it means; a word is in hexadecimal, since its bits follow.
fn value(device: &Device, pdo: &Pdo, mapped: &Mapped, raw: u64) -> String {
    let digits = usize::try_from(mapped.bits.div_ceil(4)).unwrap_or(16);
    let entry = mapped.address.and_then(|address| device.entry(address));
    if word_of(device, mapped).is_some() || mapped.data_type.is_none() {
        return format!("0x{raw:0digits$X}");
    }
    if let Some(DataType::Real32 | DataType::Real64) = mapped.data_type {
        let number = match u32::try_from(raw) {
            Ok(bits) if mapped.bits == 32 => f64::from(f32::from_bits(bits)),
            _ => f64::from_bits(raw),
        };
        return measured(device, pdo, mapped, number, number.to_string());
    }
    let shift = 64_u32.saturating_sub(mapped.bits);
    let number = match mapped.data_type {
        Some(DataType::Int(_)) => i128::from((raw << shift).cast_signed() >> shift),
        _ => i128::from(raw),
    };
    let meaning = entry.and_then(|it| it.values.iter().find(|meaning| i128::from(meaning.value) == number));
    match (meaning, mapped.data_type) {
        (Some(meaning), _) => format!("{number}: {}", meaning.name),
        (None, Some(DataType::Bitstring(_))) => format!("0x{raw:0digits$X}"),
        (None, _) => measured(device, pdo, mapped, number as f64, number.to_string()),
    }
}

/// A number with what it is in its unit.
fn measured(device: &Device, pdo: &Pdo, mapped: &Mapped, number: f64, shown: String) -> String {
    let entry = mapped.address.and_then(|address| device.entry(address));
    let object = mapped.address.and_then(|address| device.object(address.index));
    let axis = object.and_then(|object| object.axis).or(pdo.axis);
    let unit = entry.and_then(|entry| device.unit(entry.unit.as_deref()?)).and_then(|unit| unit.on(axis));
    match unit.map(|unit| (&unit.symbol, unit.scale)) {
        Some((symbol, Some(scale))) => {
            let scaled = number * scale.units as f64 / scale.raw as f64;
            format!("{shown}, {scaled} {symbol}")
        }
        Some((symbol, None)) => format!("{shown} {symbol}"),
        None => shown,
    }
}

/// The word whose bits a field is, by its id.
fn word_of(device: &Device, mapped: &Mapped) -> Option<String> {
    let address = mapped.address?;
    let leading = device.object(address.index).map_or(address.index, |object| object.leading);
    let is_it = |word: &&crate::model::Word| {
        (word.address.index, word.address.subindex) == (leading, address.subindex)
    };
    device.words.iter().find(is_it).map(|word| word.id.clone())
}

/// An emergency, CiA 301: the error code, the error register, and what the vendor makes of the rest.
fn emergency(device: &Device, bytes: &[u8]) -> Option<String> {
    let [low, high, register, rest @ ..] = bytes else { return None };
    let code = u16::from_le_bytes([*low, *high]);
    let error = device.errors.iter().rfind(|error| (error.code..=error.last).contains(&code));
    let name = match (code, error) {
        (0, _) => "no error any more".to_owned(),
        (_, Some(error)) => error.name.clone(),
        (_, None) => "a code that the description does not have".to_owned(),
    };
    let mut parts = vec![format!("emergency of {}: error 0x{code:04X}, {name}", device.name)];
    let mut rows = vec![
        vec!["bytes 0 and 1".to_owned(), "error code".to_owned(), format!("0x{code:04X}")],
        vec!["byte 2".to_owned(), "error register".to_owned(), format!("0x{register:02X}")],
    ];
    if !rest.is_empty() {
        rows.push(vec![format!("bytes 3 to {}", 2 + rest.len()), "the vendor's own".to_owned(), hex(rest)]);
    }
    parts.push(columns(&rows).join("\n"));
    parts.extend(error.into_iter().flat_map(said));
    let bits = device.words.iter().find(|word| word.address.index == ERROR_REGISTER);
    parts.extend(bits.and_then(|it| word(device, &it.id, u64::from(*register))));
    Some(parts.join("\n\n"))
}

/// What an error means, what to do, and who says so.
fn said(error: &ErrorCode) -> Vec<String> {
    let texts = [error.about.as_deref(), error.remedy.as_deref()].into_iter().flatten().map(paragraph);
    texts.chain(error.source.as_ref().map(said_by)).collect()
}

/// The bytes of a telegram.
fn message(device: &Device, telegram: &Telegram, bytes: &[u8]) -> String {
    let row = |field: &Field| {
        let range = usize::from(field.low)..=usize::from(field.high);
        let place = match field.low == field.high {
            true => format!("byte {}", field.low),
            false => format!("bytes {} to {}", field.low, field.high),
        };
        let found = bytes.get(range).unwrap_or_default();
        let raw = found.iter().rev().fold(0_i64, |value, byte| value << 8 | i64::from(*byte));
        let meaning = field.values.iter().find(|meaning| meaning.value == raw && !found.is_empty());
        let meaning = meaning.map_or(String::new(), |meaning| format!(": {}", meaning.name));
        let shown = if found.is_empty() { "missing".to_owned() } else { hex(found) };
        vec![place, field.name.clone(), format!("{shown}{meaning}")]
    };
    let rows: Vec<Vec<String>> = telegram.fields.iter().map(row).collect();
    let head = format!("{} of {}", telegram.name, device.name);
    let parts = [head, columns(&rows).join("\n")].into_iter();
    parts.chain(telegram.source.as_ref().map(said_by)).collect::<Vec<_>>().join("\n\n")
}
