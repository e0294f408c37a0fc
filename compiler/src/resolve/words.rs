//! Words made of bits.

use std::collections::BTreeMap;

use super::context::Context;
use super::ids::Siblings;
use super::{facts, keys, objects, values};
use crate::model::{Field, Object, Word};
use crate::raw::{Entity, RawField, RawWord};
use crate::source::Origin;

/// The words, in the order in which they were written.
pub(super) fn words(context: &mut Context<'_>, raw: Vec<Entity<RawWord>>, objects: &[Object]) -> Vec<Word> {
    raw.into_iter().filter_map(|entity| word(context, entity, objects)).collect()
}

fn word(context: &mut Context<'_>, entity: Entity<RawWord>, objects: &[Object]) -> Option<Word> {
    let Entity { key, origin, raw, facts } = entity;
    let object = raw.object.as_deref().unwrap_or(&key);
    let address = context.address(object, origin.value("object"))?;
    let found = objects::at(objects, address.index)?;
    let Some(entry) = found.entry(address.subindex) else {
        context.no_entry(found, address, origin.value("object"));
        return None;
    };
    Some(Word {
        name: raw.name.unwrap_or_else(|| found.name.clone()),
        address,
        bits: entry.data_type.bits(),
        fields: fields(context, &raw.bits, &origin, "bits"),
        about: raw.about,
        source: facts::source(context, &facts),
        id: key,
        origin,
    })
}

/// Bits and groups of bits, lowest first.
pub(super) fn fields(
    context: &mut Context<'_>,
    raw: &BTreeMap<String, RawField>,
    origin: &Origin,
    path: &str,
) -> Vec<Field> {
    let mut ranged = Vec::new();
    for (key, field) in raw {
        match keys::range::<u8>(key).filter(|range| *range.end() < 64) {
            Some(range) => ranged.push((range, key, field)),
            None => {
                let at = origin.value(&format!("{path}.{key}"));
                context.invalid(key, "a bit or a group of bits such as \"4..=6\"", at);
            }
        }
    }
    ranged.sort_by_key(|(range, ..)| *range.start());
    let mut ids = Siblings::default();
    ranged
        .into_iter()
        .map(|(range, key, raw)| {
            let path = format!("{path}.{key}");
            Field {
                low: *range.start(),
                high: *range.end(),
                id: ids.claim(&raw.name),
                name: raw.name.clone(),
                about: raw.about.clone(),
                values: values::meanings(context, &raw.values, origin, &format!("{path}.values")),
                rising: raw.rising.clone(),
                falling: raw.falling.clone(),
                reserved: raw.reserved,
                per_mode: raw.per_mode,
                path,
            }
        })
        .collect()
}
