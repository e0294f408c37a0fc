//! What tables say that no source states.

use crate::model::{Assumption, Place, Section};
use crate::source::{Location, Origin, Sources, Table, Value, keys};

/// The assumptions of a table and of all tables in it.
pub(super) fn assumptions(
    place: &Place,
    header: Location,
    table: &Table,
    sources: &Sources,
) -> Vec<Assumption> {
    let mut found = own(place, header, table, sources);
    for member in &table.members {
        if let Value::Table(inner) = &member.node.value
            && &*member.key.name != "assumed"
        {
            found.extend(assumptions(&within(place, &member.key.name), member.key.at, inner, sources));
        }
    }
    found
}

/// The place of what stands under a key. The entries of an object have places of their own.
fn within(place: &Place, key: &str) -> Place {
    if place.section != Section::Objects || place.subindex.is_some() {
        return place.clone().at(key);
    }
    match (place.path.as_deref(), keys::range::<u8>(key)) {
        (Some("entries"), Some(range)) => {
            Place { path: None, ..place.clone() }.entries((*range.start(), *range.end()))
        }
        _ => place.clone().at(key),
    }
}

fn own(place: &Place, header: Location, table: &Table, sources: &Sources) -> Vec<Assumption> {
    let Some(assumed) = table.get("assumed") else { return Vec::new() };
    let one = |at: Place, value: Option<String>, reason: &str| Assumption {
        at,
        value,
        reason: reason.to_owned(),
        origin: Origin::new(header, table.clone().into()),
    };
    match &assumed.node.value {
        Value::String(reason) => vec![one(place.clone(), None, reason)],
        Value::Table(keys) => {
            let reasons = keys.members.iter().filter_map(|member| match &member.node.value {
                Value::String(reason) => Some((&member.key.name, reason)),
                _ => None,
            });
            let origin = Origin::new(header, table.clone().into());
            reasons
                .map(|(key, reason)| {
                    let value = origin.node(key).map(|node| text(sources, node.at));
                    one(place.clone().at(key), value, reason)
                })
                .collect()
        }
        _ => Vec::new(),
    }
}

/// The text that stands at a place, without the quotes.
fn text(sources: &Sources, at: Location) -> String {
    let text = sources
        .get(at.file)
        .and_then(|file| file.text.get(usize::try_from(at.start).ok()?..usize::try_from(at.end).ok()?));
    text.unwrap_or_default().trim_matches('"').to_owned()
}
