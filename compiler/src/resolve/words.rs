//! Words made of bits.

use super::context::Context;
use super::objects;
use crate::model::{Object, Word};
use crate::raw::RawWord;

/// The words, in the order in which they were written.
pub(super) fn words(context: &mut Context<'_>, raw: Vec<RawWord>, objects: &[Object]) -> Vec<Word> {
    raw.into_iter().filter_map(|raw| word(context, raw, objects)).collect()
}

fn word(context: &mut Context<'_>, raw: RawWord, objects: &[Object]) -> Option<Word> {
    let RawWord { key: id, object, name, bits: fields, about, source, origin } = raw;
    let at = origin.value("object");
    let address = context.address(object.as_deref().unwrap_or(&id), at)?;
    let found = objects::at(objects, address.index)?;
    let Some(entry) = found.entry(address.subindex) else {
        context.no_entry(found, address, at);
        return None;
    };
    let (name, bits) = (name.unwrap_or_else(|| found.name.clone()), entry.data_type.bits());
    Some(Word { id, name, address, bits, fields, about, source, origin })
}
