//! Objects, each with the difference from what a profile says of it.

use super::super::read::one_line;
use super::super::report::Report;
use super::super::toml::{Keys, Toml, get, set, set_some};
use super::described::{Described, difference, without_meaning};
use super::draft::Block;
use super::entries::{shared, tables};
use super::profile::{Base, Known};
use super::value::Said;
use super::words;
use crate::model::{Kind, SdoAccess};

/// The table of an object, and the paths of what its profile says and it does not have.
pub(super) fn block(object: &Described, known: &Known, report: &mut Report) -> (Block, Vec<String>) {
    let base = known.object(object.index);
    let key = format!("0x{:04X}", object.index);
    let mut keys = Keys::new();
    let mut without = Vec::new();
    let base_name = base.and_then(Base::name);
    let own_name = object.name.as_ref();
    let name = own_name.filter(|name| words::is_other(name, base_name.as_deref(), object.at, report));
    if let Some(name) = name {
        set(&mut keys, "name", Toml::text(name));
    }
    set_some(&mut keys, "names", object.names.clone());
    match object.kind {
        Kind::Var => var(object, base, &mut keys, &mut without),
        Kind::Array | Kind::Record => several(object, base, &mut keys, &mut without, report),
    }
    let of_profile = base.map(Base::value).unwrap_or_default();
    if let Some(about) = &object.about
        && get(&keys, "about").is_none()
        && get(&of_profile, "about").is_none_or(|known| *known != Toml::text(one_line(about)))
    {
        let place = keys.iter().position(|(name, _)| name == "entries").unwrap_or(keys.len());
        keys.insert(place, ("about".to_owned(), Toml::text(about)));
    }
    let access = object.sdo_access.map(SdoAccess::word);
    for (name, value) in [("sdo-access", access.map(Toml::text)), ("properties", object.properties.clone())] {
        let place = keys.iter().position(|(name, _)| name == "entries").unwrap_or(keys.len());
        keys.splice(place..place, value.map(|value| (name.to_owned(), value)));
    }
    let without = without.into_iter().map(|path| format!("objects.{key}.{path}")).collect();
    let remarks = object.remarks.clone();
    (Block { remarks, ..Block::new("objects", Some(key), keys) }, without)
}

/// A single value.
fn var(object: &Described, base: Option<Base<'_>>, keys: &mut Keys, without: &mut Vec<String>) {
    let Some(value) = object.values.first() else { return };
    let mut known = base.map(Base::value).unwrap_or_default();
    if base.is_some_and(|base| base.kind() != Kind::Var) {
        set(keys, "kind", Toml::text("var"));
        if base.is_some_and(|base| !base.subindices().is_empty()) {
            without.push("entries".to_owned());
        }
        known.retain(|(name, _)| name == "category");
    }
    without.extend(without_meaning(&value.keys, &known).map(|value| format!("values.{value}")));
    keys.extend(difference(&value.keys, &known));
}

/// A record or an array.
fn several(
    object: &Described,
    base: Option<Base<'_>>,
    keys: &mut Keys,
    without: &mut Vec<String>,
    report: &mut Report,
) {
    let described = base.map(Base::subindices).unwrap_or_default();
    let has = |subindex: &u8| object.values.iter().any(|value| value.subindex == *subindex);
    without.extend(described.iter().filter(|it| !has(it)).map(|it| format!("entries.{it}")));
    for (base, value) in base.iter().flat_map(|base| object.values.iter().map(move |value| (base, value))) {
        let (known, subindex) = (base.entry(value.subindex), value.subindex);
        let missing = without_meaning(&value.keys, &known).filter(|_| described.contains(&subindex));
        without.extend(missing.map(|value| format!("entries.{subindex}.values.{value}")));
    }
    let members: Vec<&Said> = object.values.iter().filter(|value| value.subindex > 0).collect();
    let shared = shared(object.category.as_ref(), &members, base);
    let entries = tables(object, &members, &shared, base, &described, report);
    let many = entries.iter().any(|(key, _)| key.contains(".."));
    let implied = match base.map(Base::kind) {
        Some(kind) => kind,
        None if entries.is_empty() => Kind::Var,
        None if many => Kind::Array,
        None => Kind::Record,
    };
    if implied != object.kind {
        set(keys, "kind", Toml::text(words::kind(object.kind)));
    }
    keys.extend(shared);
    if !entries.is_empty() {
        set(keys, "entries", Toml::Table(entries));
    }
}
