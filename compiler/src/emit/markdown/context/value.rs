//! Values of entries: hexadecimal where the digits are bits or codes, decimal where they are amounts.

use super::Context;
use crate::emit::markdown::inline::{code, text};
use crate::emit::markdown::number::decimal;
use crate::model::{DataType, Entry, Index, Meaning, Notation, Scale, Value};

impl Context<'_> {
    /// A value of an entry.
    pub(in crate::emit::markdown) fn value(&self, entry: &Entry, value: &Value) -> String {
        match (value, value.integer()) {
            (Value::Text(plain), _) if plain.is_empty() => "empty".into(),
            (Value::Text(plain), _) => code(format!("\"{plain}\"")),
            (_, Some(number)) => self.number_of(entry, number),
            (_, None) => code(value),
        }
    }

    /// A whole number of an entry.
    pub(in crate::emit::markdown) fn number_of(&self, entry: &Entry, number: i128) -> String {
        if self.is_flags(entry) { hex(entry.data_type, number) } else { code(number) }
    }

    /// A value of an entry that means something, as it is written there.
    pub(in crate::emit::markdown) fn meant(&self, entry: &Entry, meaning: &Meaning) -> String {
        match meaning.notation {
            Notation::Decimal => self.number_of(entry, meaning.value.into()),
            Notation::Hexadecimal { .. } => code(meaning.notation.written(meaning.value)),
        }
    }

    /// A default, if there is one.
    pub(in crate::emit::markdown) fn default(&self, entry: &Entry) -> String {
        let Some(value) = &entry.default else { return String::new() };
        self.value(entry, value) + &self.scaled(entry, [Some(value)])
    }

    /// The least and the greatest value, if one is given.
    pub(in crate::emit::markdown) fn range(&self, entry: &Entry) -> String {
        let show = |value: &Option<Value>| value.as_ref().map(|value| self.value(entry, value));
        let range = match (show(&entry.min), show(&entry.max)) {
            (Some(min), Some(max)) => format!("{min} to {max}"),
            (Some(min), None) => format!("{min} or more"),
            (None, Some(max)) => format!("up to {max}"),
            (None, None) => return String::new(),
        };
        range + &self.scaled(entry, [entry.min.as_ref(), entry.max.as_ref()])
    }

    /// Raw values in their unit, in brackets, where a step is not one of it; a raw number beside the name of a unit would mislead.
    fn scaled<const N: usize>(&self, entry: &Entry, values: [Option<&Value>; N]) -> String {
        let physical = || {
            let (scale, symbol) = self.scale(entry)?;
            let values = values.iter().flatten().map(|value| physical(value.integer()?, scale));
            let values: Option<Vec<String>> = values.collect();
            let values = values.filter(|values| values.iter().any(|value| value != "0"))?;
            Some(format!(" ({} {symbol})", values.join(" to ")))
        };
        physical().unwrap_or_default()
    }

    /// How an entry is scaled, if that is the same on all axes and a step is not one of its unit.
    fn scale(&self, entry: &Entry) -> Option<(Scale, String)> {
        let unit = self.device.unit(entry.unit.as_deref().filter(|_| !self.is_flags(entry))?)?;
        let first = unit.axes.first().filter(|first| unit.axes.iter().all(|other| other == *first))?;
        let scale = first.scale.filter(|scale| scale.raw != scale.units)?;
        Some((scale, text(&first.symbol)))
    }

    /// Whether the digits of a value are bits or a code rather than an amount.
    fn is_flags(&self, entry: &Entry) -> bool {
        let bits = matches!(entry.data_type, DataType::Bitstring(_) | DataType::Bits(_));
        let word = self.device.words.iter().any(|word| word.address == entry.address);
        bits || word || is_code(entry.address.index, entry.address.subindex)
    }
}

/// A raw number as so many units, if that is a decimal number that ends.
fn physical(raw: i128, scale: Scale) -> Option<String> {
    let number = decimal(raw.unsigned_abs().checked_mul(scale.units.into())?, scale.raw.into())?;
    Some(if raw < 0 { format!("−{number}") } else { number })
}

/// Device type, error codes, identity, and what the mapping and assignment objects hold.
fn is_code(index: Index, subindex: u8) -> bool {
    match index.0 {
        0x1000 | 0x1001 | 0x603F => true,
        0x1018 | 0x1600..=0x1BFF | 0x1C10..=0x1C2F => subindex > 0,
        _ => false,
    }
}

fn hex(data_type: DataType, number: i128) -> String {
    let digits = usize::try_from(data_type.bits().div_ceil(4)).unwrap_or(1);
    if number < 0 { text(&number.to_string()) } else { code(format!("0x{number:0digits$X}")) }
}
