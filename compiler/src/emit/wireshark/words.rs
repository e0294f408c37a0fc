//! Words by the id that entries name, each with what modes make of it.

use std::collections::BTreeMap;

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
    let names: BTreeMap<i64, &str> = program.modes.iter().map(|mode| (mode.code, &*mode.name)).collect();
    let mut of_modes: BTreeMap<&str, Vec<OfMode>> = BTreeMap::new();
    for word in &program.words {
        let named = word.mode.and_then(|code| Some((code, names.get(&code.into())?)));
        let of_mode = named.map(|(code, name)| OfMode { code, bits: all_bits(word, &format!("{name}.")) });
        of_modes.entry(&word.id).or_default().extend(of_mode);
    }
    let mut of = |word: &Word| OfWord {
        id: word.id.clone(),
        bits: all_bits(word, ""),
        modes: of_modes.remove(&*word.id).unwrap_or_default(),
    };
    program.words.iter().filter(|word| word.mode.is_none()).map(&mut of).collect()
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
