//! Choices of process data and mode.

use super::context::Context;
use super::derived::Basis;
use super::startup::StartUp;
use super::{mapped, pdos, writes};
use crate::diagnostic::faults;
use crate::model::{ChosenWrite, Configuration, DataType, Direction, Index, Object, Pdo, SdoWrite, Value};
use crate::raw::{RawConfiguration, RawMapped, RawWrite};
use crate::source::Origin;

/// The choices with their start-up lists, in the order in which they were written.
pub(super) fn configurations(
    context: &mut Context<'_>,
    raw: Vec<RawConfiguration>,
    objects: &[Object],
    basis: &Basis<'_>,
) -> Vec<Configuration> {
    let start_up = StartUp::of(&context.axes, objects, basis);
    raw.into_iter().map(|raw| configuration(context, raw, objects, basis, &start_up)).collect()
}

fn configuration(
    context: &mut Context<'_>,
    raw: RawConfiguration,
    objects: &[Object],
    basis: &Basis<'_>,
    start_up: &StartUp<'_>,
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
        writes,
        about,
        source,
        origin,
    } = raw;
    let writes = self::writes(context, &writes, &origin, objects);
    let outputs = assigned(context, &origin, Direction::Rx, outputs.as_deref(), basis.pdos);
    let inputs = assigned(context, &origin, Direction::Tx, inputs.as_deref(), basis.pdos);
    let mut mapped = Vec::new();
    for (key, entries) in &mapping {
        let remapped = remapped(context, &origin, key, entries, basis.pdos, objects);
        mapped.extend(remapped.into_iter().map(|pdo| Pdo { source: source.clone(), ..pdo }));
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
        writes,
        startup: Vec::new(),
        about,
        source,
        origin,
    };
    configuration.startup = start_up.list(&configuration);
    configuration
}

/// Other values to write, each with the type of its entry.
fn writes(
    context: &mut Context<'_>,
    raw: &[RawWrite],
    origin: &Origin,
    objects: &[Object],
) -> Vec<ChosenWrite> {
    let known = TRANSITIONS.map(str::to_owned);
    let mut chosen = Vec::new();
    for (i, RawWrite { entry, value, transition, why }) in raw.iter().enumerate() {
        let at = |key: &str| format!("writes.{i}.{key}");
        if let Some(transition) = transition {
            context.bind(transition, &known, "transition with a mailbox", origin.value(&at("transition")));
        }
        let Some(entry) = writes::target(context, entry, objects, origin.value(&at("entry"))) else {
            continue;
        };
        let Some(value) = writes::value(context, value, entry, origin.value(&at("value"))) else { continue };
        let (address, data_type) = (entry.address, entry.data_type);
        let data = match &value {
            Value::Text(text) if matches!(data_type, DataType::Text(_)) => text.as_bytes().to_vec(),
            number => number.little_endian(data_type),
        };
        if data.len() > LONGEST {
            let message = format!("{} bytes are too many for a start-up list", data.len());
            let at = origin.value(&at("value"));
            context.fault(&faults::UNFIT_VALUE, message, at, &format!("up to {LONGEST} bytes"));
        }
        let transition = transition.clone().unwrap_or_else(|| "PS".to_owned());
        let write = SdoWrite { transition, address, data, comment: why.clone() };
        chosen.push(ChosenWrite { value, write, at: origin.value(&format!("writes.{i}")) });
    }
    chosen
}

/// Bytes of the longest number, and of what a generated list holds of a text.
const LONGEST: usize = 8;

/// The changes of the EtherCAT state at which there is a mailbox, ETG.1000.6.
const TRANSITIONS: [&str; 6] = ["IP", "PS", "SO", "OS", "SP", "OP"];

/// The PDOs to assign, axis after axis.
fn assigned(
    context: &mut Context<'_>,
    origin: &Origin,
    way: Direction,
    list: Option<&[String]>,
    pdos: &[Pdo],
) -> Option<Vec<Index>> {
    let path = match way {
        Direction::Rx => "outputs",
        Direction::Tx => "inputs",
    };
    let mut assigned = Vec::new();
    for (i, text) in list?.iter().enumerate() {
        let mut named = pdos::named(pdos, text);
        let label = if named.is_empty() { "not described" } else { "not a PDO of this direction" };
        named.retain(|pdo| pdo.direction == way);
        if named.is_empty() {
            context.no_pdo(text, origin.value(&format!("{path}.{i}")), label);
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
        context.no_pdo(key, origin.key(&path), "not described");
    }
    let remapped = named.into_iter().map(|pdo| {
        let entries = mapped::mapped(context, entries, origin, &path, pdo.axis, objects);
        Pdo { entries, total: None, about: None, ..pdo.clone() }
    });
    remapped.collect()
}
