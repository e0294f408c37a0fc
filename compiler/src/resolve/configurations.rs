//! Choices of process data and mode.

use super::context::Context;
use super::derived::Basis;
use super::{facts, pdos, startup};
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

/// The PDOs to assign, axis after axis.
fn assigned(
    context: &mut Context<'_>,
    entity: &Entity<RawConfiguration>,
    path: &str,
    list: Option<&[String]>,
    pdos: &[Pdo],
) -> Option<Vec<Index>> {
    let mut assigned = Vec::new();
    for (i, text) in list?.iter().enumerate() {
        let named = pdos::named(pdos, text);
        if named.is_empty() {
            context.no_pdo(text, entity.origin.value(&format!("{path}.{i}")), "not described");
        }
        assigned.extend(named);
    }
    assigned.sort_by_key(|pdo| pdo.axis);
    Some(assigned.into_iter().map(|pdo| pdo.index).collect())
}

/// A PDO as the configuration maps it, on all axes that it stands for.
fn remapped(
    context: &mut Context<'_>,
    entity: &Entity<RawConfiguration>,
    key: &str,
    entries: &[RawMapped],
    pdos: &[Pdo],
    objects: &[Object],
) -> Vec<Pdo> {
    let path = format!("mapping.{key}");
    let named = pdos::named(pdos, key);
    if named.is_empty() {
        context.no_pdo(key, entity.origin.value(&path), "not described");
    }
    let remapped = named.into_iter().map(|pdo| {
        let entries = pdos::mapped(context, entries, &entity.origin, &path, pdo.axis, objects);
        Pdo { entries, total: None, about: None, ..pdo.clone() }
    });
    remapped.collect()
}
