//! What the bits of a word say.

use super::layout;
use crate::model::{Device, Field, Pattern, Word};

/// Tells what a value of a word means for a device: the state that a statusword shows, the command that a controlword
/// gives, and each bit. None if the device has no such word.
///
/// The word is called by its id, or by the beginning of it: `status`.
pub fn word(device: &Device, name: &str, value: u64) -> Option<String> {
    let word = device.words.iter().find(|word| word.id == name);
    let word = word.or_else(|| device.words.iter().find(|word| word.id.starts_with(name)))?;
    let digits = usize::try_from(word.bits.div_ceil(4)).unwrap_or(4);
    let mut lines = vec![format!("{} 0x{value:0digits$X} of {}", word.name, device.name), String::new()];
    lines.extend(shown(device, word, value));
    let rows: Vec<Vec<String>> = word.fields.iter().filter_map(|field| bits(field, value)).collect();
    lines.extend(layout::columns(&rows));
    lines.extend(modes(device, word, value));
    Some(lines.join("\n"))
}

/// What the pattern of all bits says: a state, or commands.
fn shown(device: &Device, word: &Word, value: u64) -> Vec<String> {
    let low = u16::try_from(value & 0xFFFF).unwrap_or(0);
    let fits = |pattern: &Option<Pattern>| {
        pattern.as_ref().is_some_and(|pattern| low & pattern.mask() == pattern.value())
    };
    let states = device
        .states
        .iter()
        .filter(|state| fits(&state.pattern))
        .map(|state| format!("  shows {}", state.name));
    let commands = device.commands.iter().filter(|command| fits(&command.pattern)).map(|command| {
        let edge = if command.pattern.as_ref().is_some_and(|pattern| pattern.rising() != 0) {
            ", with its edge"
        } else {
            ""
        };
        format!("  asks for {}{edge}", command.name)
    });
    let lines: Vec<String> = match word.id.as_str() {
        "statusword" => states.collect(),
        "controlword" => commands.collect(),
        _ => Vec::new(),
    };
    if lines.is_empty() { lines } else { lines.into_iter().chain([String::new()]).collect() }
}

/// A group of bits with its value; none for what means nothing and is clear.
fn bits(field: &Field, value: u64) -> Option<Vec<String>> {
    let raw = (value & field.mask()) >> field.low;
    if raw == 0 && field.reserved {
        return None;
    }
    let range = if field.low == field.high {
        field.low.to_string()
    } else {
        format!("{} to {}", field.low, field.high)
    };
    let meaning =
        i64::try_from(raw).ok().and_then(|raw| field.values.iter().find(|meaning| meaning.value == raw));
    let meaning = meaning.map_or(String::new(), |meaning| format!(": {}", meaning.name));
    let unit = if field.low == field.high { "bit" } else { "bits" };
    Some(vec![format!("{unit} {range}"), raw.to_string(), format!("{}{meaning}", field.name)])
}

/// What modes of operation make of bits.
fn modes(device: &Device, word: &Word, value: u64) -> Vec<String> {
    let of_mode = device.modes.iter().filter_map(|mode| {
        let fields = match word.id.as_str() {
            "controlword" => &mode.control_bits,
            "statusword" => &mode.status_bits,
            _ => return None,
        };
        let rows: Vec<Vec<String>> = fields.iter().filter_map(|field| bits(field, value)).collect();
        let title = format!("\nin mode {}, {}\n{}", mode.code, mode.name, layout::columns(&rows).join("\n"));
        (!rows.is_empty()).then_some(title)
    });
    of_mode.collect()
}
