//! Numbers with a meaning: modes, bits, states and errors.

use std::collections::BTreeSet;

use serde::Serialize;

use super::names::Names;
use crate::emit::escape::prose;
use crate::model::{Device, Field};

/// A number with a name.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Named {
    pub(in crate::emit) code: i64,
    pub(in crate::emit) name: String,
    pub(in crate::emit) global: String,
    pub(in crate::emit) title: String,
}

/// A mode of operation.
pub(in crate::emit) type Mode = Named;

/// A word made of bits.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Word {
    /// The id of the word, and the mode that gives its bits a meaning if it is not always the same.
    pub(in crate::emit) id: String,
    pub(in crate::emit) mode: Option<i16>,
    pub(in crate::emit) name: String,
    pub(in crate::emit) title: String,
    pub(in crate::emit) bits: u32,
    pub(in crate::emit) fields: Vec<Bits>,
}

/// Bits of a word.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Bits {
    pub(in crate::emit) name: String,
    pub(in crate::emit) global: String,
    pub(in crate::emit) title: String,
    pub(in crate::emit) low: u8,
    pub(in crate::emit) high: u8,
    pub(in crate::emit) mask: u64,
    /// The name of `low`, where there are several bits.
    pub(in crate::emit) shift: Option<String>,
    pub(in crate::emit) values: Vec<Named>,
}

/// A state of the drive.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct State {
    pub(in crate::emit) name: String,
    pub(in crate::emit) global: String,
    pub(in crate::emit) title: String,
    pub(in crate::emit) mask: u16,
    pub(in crate::emit) value: u16,
}

/// An error code, or a range of them.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Error {
    pub(in crate::emit) code: u16,
    pub(in crate::emit) last: u16,
    pub(in crate::emit) name: String,
    pub(in crate::emit) global: String,
    pub(in crate::emit) title: String,
}

/// The modes by code.
pub(super) fn modes(device: &Device, names: &mut Names) -> Vec<Mode> {
    let mut siblings = names.siblings();
    let mode = |mode: &crate::model::Mode| Named {
        code: mode.code.into(),
        name: siblings.claim(&mode.id),
        global: names.global(&["mode", &mode.id]),
        title: prose(&mode.name),
    };
    device.modes.iter().map(mode).collect()
}

/// The words, and what each mode makes of bits of the controlword and the statusword.
pub(super) fn words(device: &Device, names: &mut Names) -> Vec<Word> {
    let mut siblings = names.siblings();
    let mut words: Vec<Word> = Vec::new();
    for word in &device.words {
        let (name, title) = (siblings.claim(&word.id), prose(&word.name));
        let fields = fields(&word.id, &word.fields, names);
        words.push(Word { id: word.id.clone(), mode: None, name, title, bits: word.bits, fields });
    }
    for mode in &device.modes {
        for (what, bits) in [("control", &mode.control_bits), ("status", &mode.status_bits)] {
            let id = format!("{}-{what}", mode.id);
            let fields = fields(&id, bits, names);
            let width = device.words.iter().map(|word| word.bits).max().unwrap_or(16).min(16);
            if !fields.is_empty() {
                let title = prose(&format!("{}: {what} bits", mode.name));
                let name = siblings.claim(&id);
                let mode = Some(mode.code);
                words.push(Word { id: format!("{what}word"), mode, name, title, bits: width, fields });
            }
        }
    }
    words
}

/// The bits that mean something whatever the mode is.
fn fields<'f>(word: &str, fields: impl IntoIterator<Item = &'f Field>, names: &mut Names) -> Vec<Bits> {
    let mut siblings = names.siblings();
    let told = fields.into_iter().filter(|field| !field.reserved && !field.per_mode);
    told.map(|field| Bits {
        name: siblings.claim(&field.id),
        global: names.global(&[word, &field.id]),
        title: prose(&field.name),
        low: field.low,
        high: field.high,
        mask: field.mask(),
        shift: (field.low != field.high).then(|| names.global(&[word, &field.id, "shift"])),
        values: values(word, field, names),
    })
    .collect()
}

fn values(word: &str, field: &Field, names: &mut Names) -> Vec<Named> {
    let mut siblings = names.siblings();
    let value = |value: &crate::model::Meaning| Named {
        code: value.value,
        name: siblings.claim(&value.id),
        global: names.global(&[word, &field.id, &value.id]),
        title: prose(&value.name),
    };
    field.values.iter().filter(|value| value.value >= 0).map(value).collect()
}

/// The states that a pattern of the statusword shows.
pub(super) fn states(device: &Device, names: &mut Names) -> Vec<State> {
    let mut siblings = names.siblings();
    let shown = device.states.iter().filter_map(|state| Some((state, state.pattern.as_ref()?)));
    let mut states = Vec::new();
    for (state, pattern) in shown {
        let global = names.global(&["state", &state.id]);
        names.reserve(&global, &["mask", "value"]);
        let (name, title) = (siblings.claim(&state.id), prose(&state.name));
        states.push(State { name, global, title, mask: pattern.mask(), value: pattern.value() });
    }
    states
}

/// The error codes of 0x603F, each once: single codes, then ranges.
pub(super) fn errors(device: &Device, names: &mut Names) -> Vec<Error> {
    let (mut siblings, mut known) = (names.siblings(), BTreeSet::new());
    let mut errors: Vec<_> = device.errors.iter().collect();
    errors.sort_by_key(|error| (error.is_range(), error.code));
    errors.retain(|error| known.insert((error.code, error.last)));
    let error = |error: &crate::model::ErrorCode| Error {
        code: error.code,
        last: error.last,
        name: siblings.claim(&error.id),
        global: names.global(&["error", &error.id]),
        title: prose(&error.name),
    };
    errors.into_iter().map(error).collect()
}

/// The AL status codes, each once.
pub(super) fn al_codes(device: &Device) -> Vec<Named> {
    let mut known = BTreeSet::new();
    let codes = device.al_status_codes.iter().filter(|code| known.insert(code.code));
    codes
        .map(|code| Named {
            code: code.code.into(),
            name: String::new(),
            global: String::new(),
            title: prose(&code.name),
        })
        .collect()
}
