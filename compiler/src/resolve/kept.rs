//! Tables that stand in the model as they were read: what remains is their order, their ids, and that what they refer to
//! is there.

use super::context::Context;
use crate::diagnostic::{Diagnostic, faults};
use crate::model::ids::Siblings;
use crate::model::{Device, ErrorCode, HomingMethod, ModePdo, Pdo, Role, SyncMode, Transition};
use crate::source::{Layer, Location, Origin};

/// The same tables in the order of a key.
pub(super) fn sorted<T, K: Ord>(mut tables: Vec<T>, key: impl FnMut(&T) -> K) -> Vec<T> {
    tables.sort_by_key(key);
    tables
}

/// The error codes and ranges of them, by code, a range before what is in it; each with an id of its own.
pub(super) fn errors(mut errors: Vec<ErrorCode>) -> Vec<ErrorCode> {
    let mut ids = Siblings::default();
    errors.iter_mut().for_each(|error| error.id = ids.claim(&error.name));
    sorted(errors, |error| (error.code, std::cmp::Reverse(error.last)))
}

/// The homing methods, by number, each with an id of its own.
pub(super) fn homing_methods(mut methods: Vec<HomingMethod>) -> Vec<HomingMethod> {
    let mut ids = Siblings::default();
    methods.iter_mut().for_each(|method| method.id = ids.claim(&method.name));
    sorted(methods, |method| method.number)
}

/// The ways to keep time, the default first.
pub(super) fn sync_modes(modes: Vec<SyncMode>) -> Vec<SyncMode> {
    sorted(modes, |mode| !mode.default)
}

/// Reports what tables refer to and is not there.
pub(super) fn references(context: &mut Context<'_>, device: &Device) {
    let states: Vec<String> = device.states.iter().map(|state| state.id.clone()).collect();
    for Transition { from, to, origin, .. } in &device.transitions {
        bind_all(context, from, &states, "state", origin, "from");
        context.bind(to, &states, "state", origin.value("to"));
    }
    for command in &device.commands {
        bind_all(context, &command.ignored_in, &states, "state", &command.origin, "ignored-in");
        transitions(context, &command.transitions, device, &command.origin);
    }
    for option in &device.stop_options {
        transitions(context, &option.transitions, device, &option.origin);
    }
    if let Some(control) = &device.device_control {
        let selectable = &control.modes_selectable_in;
        bind_all(context, selectable, &states, "state", &control.origin, "modes-selectable-in");
    }
    let axes: Vec<String> = device.axes.iter().map(|axis| axis.name.clone()).collect();
    for module in &device.modules {
        bind_all(context, &module.axes, &axes, "axis", &module.origin, "axes");
    }
    for change in &device.mode_changes {
        modes(context, &change.from, device, &change.origin, "from");
        modes(context, &change.to, device, &change.origin, "to");
    }
    let states: Vec<String> = device.communication_states.iter().map(|state| state.id.clone()).collect();
    for transition in &device.communication_transitions {
        let what = "communication state";
        context.bind(&transition.from, &states, what, transition.origin.value("from"));
        context.bind(&transition.to, &states, what, transition.origin.value("to"));
    }
    mode_managers(context, device);
    addresses(context, device);
}

/// Binds references; the place of a text that stands alone is that of the key.
fn bind_all(
    context: &mut Context<'_>,
    texts: &[String],
    known: &[String],
    what: &str,
    origin: &Origin,
    path: &str,
) {
    for (i, text) in texts.iter().enumerate() {
        let item = format!("{path}.{i}");
        let place = if origin.has(&item) { origin.value(&item) } else { origin.value(path) };
        context.bind(text, known, what, place);
    }
}

/// Reports numbers of transitions that are not described.
fn transitions(context: &mut Context<'_>, numbers: &[u8], device: &Device, origin: &Origin) {
    for (i, number) in numbers.iter().enumerate() {
        if !device.transitions.iter().any(|transition| transition.number == *number) {
            let message = format!("there is no transition {number}");
            let fault = |at, label| Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, at, label);
            context.diagnostics.push(match origin.layer("transitions") {
                // Nothing of it stands in the description but the mention of the command.
                Some(Layer::Profile) => fault(origin.header(), "the profile sets it off by this")
                    .label(origin.value("transitions"), "in the profile")
                    .help(format!("add `[transitions.{number}]`, or say here which `transitions` there are")),
                _ => fault(origin.value(&format!("transitions.{i}")), "not in `[transitions]`"),
            });
        }
    }
}

/// Reports codes of modes that are not described.
fn modes(context: &mut Context<'_>, codes: &[i16], device: &Device, origin: &Origin, path: &str) {
    let known: Vec<i16> =
        device.modes.iter().flat_map(|mode| mode.aliases.iter().copied().chain([mode.code])).collect();
    for (i, code) in codes.iter().enumerate() {
        mode(context, *code, &known, origin.value(&format!("{path}.{i}")));
    }
}

/// Reports a code of a mode that is not described.
pub(super) fn mode(context: &mut Context<'_>, code: i16, known: &[i16], at: Location) {
    if !known.contains(&code) {
        let message = format!("there is no mode of operation {code}");
        context.fault(&faults::UNKNOWN_REFERENCE, message, at, "not in `[modes]`");
    }
}

/// Reports sync managers and PDOs that ways to keep time name and that are not there.
fn mode_managers(context: &mut Context<'_>, device: &Device) {
    let known: Vec<String> = device.sync_managers.iter().map(|manager| manager.id.clone()).collect();
    for (mode, named) in
        device.sync_modes.iter().flat_map(|mode| mode.managers.iter().map(move |it| (mode, it)))
    {
        let place = format!("managers.{}", named.id);
        if !context.bind_key(&named.id, &known, "sync manager", mode.origin.key(&place)) {
            continue;
        }
        let carries = |pdo: &Pdo| {
            let role = Role::of(pdo.direction);
            device.sync_managers.iter().any(|manager| manager.id == named.id && manager.role == role)
        };
        for (i, ModePdo { pdo, .. }) in named.pdos.iter().enumerate() {
            if !device.pdo(*pdo).is_some_and(carries) {
                let at = mode.origin.value(&format!("{place}.pdos.{i}.pdo"));
                match device.pdo(*pdo) {
                    None => context.no_pdo(&pdo.to_string(), at, "not described"),
                    Some(other) => {
                        let message = format!("`{}` does not carry {pdo}", named.id);
                        let label = "of the other direction";
                        let fault = Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, at, label);
                        context.diagnostics.push(fault.label(other.origin.header(), "this PDO"));
                    }
                }
            }
        }
    }
}

/// Reports references to entries that their objects do not have.
fn addresses(context: &mut Context<'_>, device: &Device) {
    let modes = device
        .modes
        .iter()
        .flat_map(|mode| mode.objects.iter().map(|address| (*address, &mode.origin, "objects")));
    let factors = device.units.iter().filter_map(|unit| Some((unit.factor?, &unit.origin, "factor")));
    let entries = device.objects.iter().flat_map(|object| &object.entries);
    let triggers = entries.flat_map(|entry| {
        let Some(trigger) = &entry.trigger else { return Vec::new() };
        let uses = trigger.uses.iter().map(|address| (*address, &entry.origin, "trigger.uses"));
        let updates = trigger.updates.iter().map(|address| (*address, &entry.origin, "trigger.updates"));
        uses.chain(updates).collect()
    });
    for (address, origin, path) in modes.chain(factors).chain(triggers) {
        if let Some(object) =
            device.object(address.index).filter(|object| object.entry(address.subindex).is_none())
        {
            context.no_entry(object, address, origin.value(path));
        }
    }
}
