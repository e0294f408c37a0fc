//! Words by the id that entries name, each with what modes make of it.

use serde::Serialize;

use super::entries::Meaning;
use crate::emit::program::{Bits, Program, Word};

/// A word.
#[derive(Debug, Serialize)]
pub(super) struct OfWord {
    id: String,
    bits: Vec<OfBits>,
    modes: Vec<OfMode>,
}

/// What a mode makes of bits.
#[derive(Debug, Serialize)]
struct OfMode {
    code: i16,
    bits: Vec<OfBits>,
}

/// Bits, by the filter that they have behind that of their word.
#[derive(Debug, Serialize)]
struct OfBits {
    low: u8,
    high: u8,
    filter: String,
    title: String,
    values: Vec<Meaning>,
}

/// All words.
pub(super) fn words(program: &Program) -> Vec<OfWord> {
    let of = |word: &Word| {
        let of_modes = program.words.iter().filter(|other| other.id == word.id);
        let of_modes = of_modes.filter_map(|other| {
            let code = other.mode?;
            let mode = program.modes.iter().find(|mode| mode.code == i64::from(code))?;
            Some(OfMode { code, bits: all_bits(other, &format!("{}.", mode.name)) })
        });
        OfWord { id: word.id.clone(), bits: all_bits(word, ""), modes: of_modes.collect() }
    };
    program.words.iter().filter(|word| word.mode.is_none()).map(of).collect()
}

fn all_bits(word: &Word, prefix: &str) -> Vec<OfBits> {
    let of = |bits: &Bits| OfBits {
        low: bits.low,
        high: bits.high,
        filter: format!("{prefix}{}", bits.name),
        title: bits.title.clone(),
        values: bits.values.iter().map(|it| (it.code, it.code, it.title.clone())).collect(),
    };
    word.fields.iter().map(of).collect()
}
