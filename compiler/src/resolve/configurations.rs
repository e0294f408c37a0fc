//! Choices of process data and mode.

use super::context::Context;
use super::derived::Basis;
use super::{facts, names, pdos, startup};
use crate::diagnostic::{Diagnostic, faults};
use crate::model::{Configuration, Index, Object, Pdo};
use crate::raw::{Duration, Entity, RawConfiguration, RawMapped};

/// The choices with their start-up lists, in the order in which they were written.
pub(super) fn configurations(
    context: &mut Context<'_>,
    raw: Vec<Entity<RawConfiguration>>,
    objects: &[Object],
    basis: &Basis<'_>,
) -> Vec<Configuration> {
    raw.into_iter().map(|entity| configuration(context, entity, objects, basis)).collect()
}

fn configuration(
    context: &mut Context<'_>,
    entity: Entity<RawConfiguration>,
    objects: &[Object],
    basis: &Basis<'_>,
) -> Configuration {
    let outputs = assigned(context, &entity, "outputs", entity.raw.outputs.as_deref(), basis.pdos);
    let inputs = assigned(context, &entity, "inputs", entity.raw.inputs.as_deref(), basis.pdos);
    let mut mapping = Vec::new();
    for (key, entries) in &entity.raw.mapping {
        mapping.extend(remapped(context, &entity, key, entries, basis.pdos, objects));
    }
    let Entity { key, raw, facts, origin } = entity;
    let mut configuration = Configuration {
        id: key,
        name: raw.name,
        outputs,
        inputs,
        mapping,
        mode: raw.mode,
        cycle_ns: raw.cycle_time.map(|Duration(ns)| ns),
        startup: Vec::new(),
        about: raw.about,
        source: facts::source(context, &facts),
        origin,
    };
    configuration.startup = startup::startup(context, &configuration, objects, basis.mailbox);
    configuration
}

fn assigned(
    context: &mut Context<'_>,
    entity: &Entity<RawConfiguration>,
    path: &str,
    list: Option<&[String]>,
    pdos: &[Pdo],
) -> Option<Vec<Index>> {
    let mut assigned = Vec::new();
    for (i, text) in list?.iter().enumerate() {
        let index = names::index(text).filter(|index| pdos.iter().any(|pdo| pdo.index == *index));
        if index.is_none() {
            unknown_pdo(context, text, entity.origin.value(&format!("{path}.{i}")));
        }
        assigned.extend(index);
    }
    Some(assigned)
}

fn unknown_pdo(context: &mut Context<'_>, text: &str, at: crate::source::Location) {
    let message = format!("there is no PDO `{text}`");
    context.diagnostics.push(Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, at, "not described"));
}

/// A PDO as the configuration maps it; with a PDO of the first axis, those of the others.
fn remapped(
    context: &mut Context<'_>,
    entity: &Entity<RawConfiguration>,
    key: &str,
    entries: &[RawMapped],
    pdos: &[Pdo],
    objects: &[Object],
) -> Vec<Pdo> {
    let path = format!("mapping.{key}");
    let Some(named) = names::index(key).and_then(|index| pdos.iter().find(|pdo| pdo.index == index)) else {
        unknown_pdo(context, key, entity.origin.value(&path));
        return Vec::new();
    };
    // The copies of a PDO stand at one place in the description.
    let place = named.origin.header();
    let copies = |pdo: &&Pdo| named.axis == Some(0) && pdo.origin.header() == place;
    let mut remapped = Vec::new();
    for pdo in pdos.iter().filter(|pdo| pdo.index == named.index || copies(pdo)) {
        let entries = pdos::mapped(context, entries, &entity.origin, &path, pdo.axis, objects);
        remapped.push(Pdo { entries, total: None, about: None, ..pdo.clone() });
    }
    remapped
}
