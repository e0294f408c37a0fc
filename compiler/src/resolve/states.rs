//! The state machines.

use super::context::Context;
use super::facts;
use super::keys;
use crate::diagnostic::faults;
use crate::model::{
    Answer, Command, CommunicationState, CommunicationTransition, Event, Pattern, Scope, State, Transition,
};
use crate::raw::{
    Entity, RawAnswer, RawCommand, RawCommunicationState, RawCommunicationTransition, RawEvent, RawScope,
    RawState, RawTransition,
};
use crate::source::Origin;

/// The states of the drive, in the order in which they were written.
pub(super) fn states(context: &mut Context<'_>, raw: Vec<Entity<RawState>>) -> Vec<State> {
    raw.into_iter()
        .map(|Entity { key, origin, raw, facts }| State {
            pattern: pattern(context, raw.pattern.as_deref(), &origin),
            source: facts::source(context, &facts),
            id: key,
            name: raw.name,
            about: raw.about,
            brake: raw.brake.map(answer),
            low_level_power: raw.low_level_power.map(answer),
            high_level_power: raw.high_level_power.map(answer),
            drive_function: raw.drive_function.map(answer),
            configuration: raw.configuration.map(answer),
            features: raw.features,
            causes: raw.causes,
            origin,
        })
        .collect()
}

fn answer(raw: RawAnswer) -> Answer {
    match raw {
        RawAnswer::Yes => Answer::Yes,
        RawAnswer::No => Answer::No,
        RawAnswer::IfRequired => Answer::IfRequired,
    }
}

fn pattern(context: &mut Context<'_>, text: Option<&str>, origin: &Origin) -> Option<Pattern> {
    let text = text?;
    let pattern = Pattern::parse(text);
    if pattern.is_none() {
        let expected = "a pattern of up to 16 bits, each 0, 1, x, r or f, such as \"x01x 0001\"";
        context.invalid(text, expected, origin.value("pattern"));
    }
    pattern
}

/// The commands, in the order in which they were written.
pub(super) fn commands(
    context: &mut Context<'_>,
    raw: Vec<Entity<RawCommand>>,
    states: &[String],
) -> Vec<Command> {
    raw.into_iter()
        .map(|Entity { key, origin, raw, facts }| Command {
            pattern: pattern(context, raw.pattern.as_deref(), &origin),
            ignored_in: bind_all(context, &raw.ignored_in, states, &origin, "ignored-in"),
            source: facts::source(context, &facts),
            id: key,
            name: raw.name,
            transitions: raw.transitions,
            about: raw.about,
            origin,
        })
        .collect()
}

/// Binds references to states; the place of a text that stands alone is that of the key.
pub(super) fn bind_all(
    context: &mut Context<'_>,
    texts: &[String],
    known: &[String],
    origin: &Origin,
    path: &str,
) -> Vec<String> {
    let place = |i: usize| {
        let item = format!("{path}.{i}");
        if origin.has(&item) { origin.value(&item) } else { origin.value(path) }
    };
    let places = texts.iter().enumerate();
    places.filter_map(|(i, text)| context.bind(text, known, "state", place(i))).collect()
}

/// The changes of state, by number.
pub(super) fn transitions(
    context: &mut Context<'_>,
    raw: Vec<Entity<RawTransition>>,
    states: &[String],
) -> Vec<Transition> {
    let mut transitions: Vec<_> =
        raw.into_iter().filter_map(|entity| transition(context, entity, states)).collect();
    transitions.sort_by_key(|transition| transition.number);
    transitions
}

fn transition(
    context: &mut Context<'_>,
    entity: Entity<RawTransition>,
    states: &[String],
) -> Option<Transition> {
    let Entity { key, origin, raw, facts } = entity;
    let number = keys::number(&key).and_then(|number| u8::try_from(number).ok());
    if number.is_none() {
        context.invalid(&key, "the number of a transition", origin.header());
    }
    let from = bind_all(context, &raw.from.0, states, &origin, "from");
    let to = context.bind(&raw.to, states, "state", origin.value("to"));
    Some(Transition {
        number: number?,
        from,
        to: to?,
        automatic: raw.automatic,
        supported: raw.supported.unwrap_or(true),
        pattern: pattern(context, raw.pattern.as_deref(), &origin),
        command: raw.command,
        events: raw.events.into_iter().map(event).collect(),
        interlocks: raw.interlocks.into_iter().map(event).collect(),
        axes: raw.axes.map(|scope| match scope {
            RawScope::All => Scope::All,
            RawScope::Any => Scope::Any,
        }),
        power: raw.power,
        conditions: raw.conditions,
        causes: raw.causes,
        about: raw.about,
        source: facts::source(context, &facts),
        origin,
    })
}

fn event(raw: RawEvent) -> Event {
    match raw {
        RawEvent::Initialised => Event::Initialised,
        RawEvent::Fault => Event::Fault,
        RawEvent::FaultReactionOver => Event::FaultReactionOver,
        RawEvent::QuickStopOver => Event::QuickStopOver,
        RawEvent::LockedOut => Event::LockedOut,
        RawEvent::NotEnabled => Event::NotEnabled,
    }
}

/// The EtherCAT states, by code.
pub(super) fn communication_states(
    context: &Context<'_>,
    raw: Vec<Entity<RawCommunicationState>>,
) -> Vec<CommunicationState> {
    let mut states: Vec<_> = raw
        .into_iter()
        .map(|Entity { key, raw, facts, .. }| CommunicationState {
            id: key,
            name: raw.name,
            code: raw.code,
            about: raw.about,
            source: facts::source(context, &facts),
        })
        .collect();
    states.sort_by_key(|state| state.code);
    states
}

/// The changes of the EtherCAT state, in the order in which they were written.
pub(super) fn communication_transitions(
    context: &mut Context<'_>,
    raw: Vec<Entity<RawCommunicationTransition>>,
    states: &[String],
) -> Vec<CommunicationTransition> {
    raw.into_iter()
        .filter_map(|Entity { key, raw, facts, origin }| {
            let what = "communication state";
            let from = context.bind(&raw.from, states, what, origin.value("from"));
            let to = context.bind(&raw.to, states, what, origin.value("to"));
            let source = facts::source(context, &facts);
            Some(CommunicationTransition { id: key, from: from?, to: to?, about: raw.about, source })
        })
        .collect()
}

/// Reports a list of transition numbers that are not described.
pub(super) fn check_numbers(
    context: &mut Context<'_>,
    numbers: &[u8],
    known: &[Transition],
    origin: &Origin,
) {
    for (i, number) in numbers.iter().enumerate() {
        if !known.iter().any(|transition| transition.number == *number) {
            let message = format!("there is no transition {number}");
            let at = origin.value(&format!("transitions.{i}"));
            context.fault(&faults::UNKNOWN_REFERENCE, message, at, "not in `[transitions]`");
        }
    }
}
