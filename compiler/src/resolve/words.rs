//! Words made of bits.

use std::collections::BTreeMap;

use super::context::Context;
use super::objects;
use crate::diagnostic::{Diagnostic, faults};
use crate::model::{DataType, Object, Word};
use crate::raw::RawWord;

/// The words, in the order in which they were written.
pub(super) fn words(context: &mut Context<'_>, raw: Vec<RawWord>, objects: &[Object]) -> Vec<Word> {
    let words: Vec<Word> = raw.into_iter().filter_map(|raw| word(context, raw, objects)).collect();
    let mut known = BTreeMap::new();
    for word in &words {
        let at = word.origin.value("object");
        match known.get(&word.address) {
            None => drop(known.insert(word.address, (&word.id, at))),
            Some((other, label)) => {
                let message = format!("the bits of {} are `{other}` and `{}`", word.address, word.id);
                let fault = Diagnostic::new(&faults::DUPLICATE_DEFINITION, message, at, "here, too");
                let fault = fault.label(*label, "already here").help("say all of its bits in one of them");
                context.diagnostics.push(fault);
            }
        }
    }
    words
}

/// A word of a number, a string of bits, or bytes.
fn word(context: &mut Context<'_>, raw: RawWord, objects: &[Object]) -> Option<Word> {
    use DataType::{Array, Real32, Real64, Text, Unicode};
    let RawWord { key: id, object, name, bits: fields, about, source, origin } = raw;
    let at = origin.value("object");
    let address = context.address(object.as_deref().unwrap_or(&id), at)?;
    let found = objects::at(objects, address.index)?;
    let Some(entry) = found.entry(address.subindex) else {
        context.no_entry(found, address, at);
        return None;
    };
    if matches!(entry.data_type, Real32 | Real64 | Text(_) | Unicode(_) | Array(..)) {
        let message = format!("{address} is {}, which has no bits of its own", entry.data_type);
        let fault = Diagnostic::new(&faults::INVALID_VALUE, message, at, "no word");
        context.diagnostics.push(fault.label(entry.origin.value("type"), "its type"));
        return None;
    }
    let (name, bits) = (name.unwrap_or_else(|| found.name.clone()), entry.data_type.bits());
    Some(Word { id, name, address, bits, fields, about, source, origin })
}
