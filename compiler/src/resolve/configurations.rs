//! Choices of process data and mode.

use super::context::Context;
use super::derived::Basis;
use super::{pdos, startup};
use crate::model::{Configuration, Index, Object, Pdo};
use crate::raw::{RawConfiguration, RawMapped};
use crate::source::Origin;

/// The choices with their start-up lists, in the order in which they were written.
pub(super) fn configurations(
    context: &mut Context<'_>,
    raw: Vec<RawConfiguration>,
    objects: &[Object],
    basis: &Basis<'_>,
) -> Vec<Configuration> {
    raw.into_iter().map(|raw| configuration(context, raw, objects, basis)).collect()
}

fn configuration(
    context: &mut Context<'_>,
    raw: RawConfiguration,
    objects: &[Object],
    basis: &Basis<'_>,
) -> Configuration {
    let RawConfiguration {
        key: id,
        name,
        default,
        outputs,
        inputs,
        mapping,
        mode,
        cycle_time,
        about,
        source,
        origin,
    } = raw;
    let outputs = assigned(context, &origin, "outputs", outputs.as_deref(), basis.pdos);
    let inputs = assigned(context, &origin, "inputs", inputs.as_deref(), basis.pdos);
    let mut mapped = Vec::new();
    for (key, entries) in &mapping {
        mapped.extend(remapped(context, &origin, key, entries, basis.pdos, objects));
    }
    let mut configuration = Configuration {
        id,
        name,
        default,
        outputs,
        inputs,
        mapping: mapped,
        mode,
        cycle_time,
        startup: Vec::new(),
        about,
        source,
        origin,
    };
    configuration.startup =
        startup::startup(context, &configuration, objects, basis.mailbox, basis.sync_managers);
    configuration
}

/// The PDOs to assign, axis after axis.
fn assigned(
    context: &mut Context<'_>,
    origin: &Origin,
    path: &str,
    list: Option<&[String]>,
    pdos: &[Pdo],
) -> Option<Vec<Index>> {
    let mut assigned = Vec::new();
    for (i, text) in list?.iter().enumerate() {
        let named = pdos::named(pdos, text);
        if named.is_empty() {
            context.no_pdo(text, origin.value(&format!("{path}.{i}")), "not described");
        }
        assigned.extend(named);
    }
    assigned.sort_by_key(|pdo| pdo.axis);
    Some(assigned.into_iter().map(|pdo| pdo.index).collect())
}

/// A PDO as the configuration maps it, on all axes that it stands for.
fn remapped(
    context: &mut Context<'_>,
    origin: &Origin,
    key: &str,
    entries: &[RawMapped],
    pdos: &[Pdo],
    objects: &[Object],
) -> Vec<Pdo> {
    let path = format!("mapping.{key}");
    let named = pdos::named(pdos, key);
    if named.is_empty() {
        context.no_pdo(key, origin.value(&path), "not described");
    }
    let remapped = named.into_iter().map(|pdo| {
        let entries = pdos::mapped(context, entries, origin, &path, pdo.axis, objects);
        Pdo { entries, total: None, about: None, ..pdo.clone() }
    });
    remapped.collect()
}
