//! The state machine of a device, as its description has it.

use devc::model::{self, Device, Event, Given, Transition};
use devc_runtime::cia402::{
    Command, Condition, Coupling, Edge, Events, Machine, ModeChange, Modes, Pattern, Refusal, State,
    StatePatterns, StateSet, generic,
};

use super::forever;

/// The machine of a device; that of the profile for one whose description has none, with the modes of the device.
pub(super) fn machine(device: &Device) -> &'static Machine {
    let modes = modes(device);
    if device.states.is_empty() || device.transitions.is_empty() {
        return forever::value(Machine { modes, ..generic::MACHINE });
    }
    let control = device.device_control.as_ref();
    forever::value(Machine {
        states: StatePatterns(forever::all(device.states.iter().filter_map(pattern_of_state))),
        commands: forever::all(device.given().map(|given| command(device, given))),
        transitions: forever::all(device.transitions.iter().filter_map(|one| transition(device, one))),
        conditions: forever::all(conditions(device)),
        refusal: control.map_or(Refusal::Ignored, |control| refusal(control.wrong_command)),
        modes,
    })
}

/// The state of an id.
pub(super) fn state(id: &str) -> Option<State> {
    let mut states = model::State::OF_PROFILE.iter().zip(State::ALL);
    states.find(|(known, _)| **known == id).map(|(_, state)| state)
}

fn states<'a>(ids: impl IntoIterator<Item = &'a str>) -> StateSet {
    ids.into_iter().filter_map(state).fold(StateSet::NONE, StateSet::with)
}

fn pattern_of_state(one: &model::State) -> Option<(State, Pattern)> {
    Some((state(&one.id)?, pattern(one.pattern.as_ref()?)))
}

fn pattern(pattern: &model::Pattern) -> Pattern {
    Pattern { mask: pattern.mask(), value: pattern.value() }
}

fn command(device: &Device, given: Given<'_>) -> Command {
    let bits = given.pattern();
    Command {
        name: forever::text(&given.name()),
        pattern: pattern(bits),
        edge: match (bits.rising(), bits.falling()) {
            (0, 0) => None,
            (0, falling) => Some(Edge::Falling(falling)),
            (rising, _) => Some(Edge::Rising(rising)),
        },
        transitions: forever::all(device.set_off(given)),
        ignored_in: states(given.ignored_in().iter().map(String::as_str)),
    }
}

fn transition(device: &Device, one: &Transition) -> Option<devc_runtime::cia402::Transition> {
    let coupling = match one.axes {
        None => Coupling::Independent,
        Some(model::Scope::All) => Coupling::All,
        Some(model::Scope::Any) => Coupling::Any,
    };
    one.supported.then_some(devc_runtime::cia402::Transition {
        number: one.number,
        from: states(device.origins(one)),
        to: state(&one.to)?,
        coupling,
    })
}

/// What makes transitions, the most urgent first, then what hinders them.
fn conditions(device: &Device) -> Vec<Condition> {
    let caused = device.caused().into_iter().map(|one| Condition::caused(one.number, events(&one.events)));
    let hindered = device.transitions.iter().filter(|one| one.supported && !one.interlocks.is_empty());
    caused.chain(hindered.map(|one| Condition::hindered(one.number, events(&one.interlocks)))).collect()
}

fn events(events: &[Event]) -> Events {
    events.iter().fold(Events::NONE, |all, event| {
        all | match event {
            Event::Initialised => Events::INITIALISED,
            Event::Fault => Events::FAULT,
            Event::FaultReactionOver => Events::FAULT_REACTION_OVER,
            Event::QuickStopOver => Events::QUICK_STOP_OVER,
            Event::LockedOut => Events::LOCKED_OUT,
            Event::NotEnabled => Events::NOT_ENABLED,
        }
    })
}

fn refusal(refusal: model::Refusal) -> Refusal {
    match refusal {
        model::Refusal::Ignored => Refusal::Ignored,
        model::Refusal::Fault => Refusal::Fault,
    }
}

fn modes(device: &Device) -> Modes {
    let control = device.device_control.as_ref();
    let selectable = control.map_or(&[][..], |control| &control.modes_selectable_in);
    let selectable_in = states(selectable.iter().map(String::as_str));
    Modes {
        supported: forever::all(device.mode_codes()),
        changes: forever::all(device.mode_changes.iter().map(change)),
        selectable_in: if selectable_in.is_empty() { StateSet::ALL } else { selectable_in },
        refusal: control.map_or(Refusal::Ignored, |control| refusal(control.wrong_mode)),
    }
}

fn change(change: &model::ModeChange) -> ModeChange {
    let codes = |codes: &[i16]| forever::all(codes.iter().filter_map(|code| i8::try_from(*code).ok()));
    ModeChange { from: codes(&change.from), to: codes(&change.to) }
}
