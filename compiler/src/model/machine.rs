//! The state machine of a drive as one runs it: what the tables of states, commands and transitions say together.

use super::{Command, Device, Pattern, Transition};

/// What a controlword asks for.
#[derive(Debug, Clone, Copy)]
pub enum Given<'a> {
    /// A command.
    Command(&'a Command, &'a Pattern),
    /// A transition that follows bits of its own.
    Transition(&'a Transition, &'a Pattern),
}

impl<'a> Given<'a> {
    /// The bits that ask for it.
    pub fn pattern(self) -> &'a Pattern {
        match self {
            Self::Command(_, pattern) | Self::Transition(_, pattern) => pattern,
        }
    }

    /// Its name for people.
    pub fn name(self) -> String {
        match self {
            Self::Command(command, _) => command.name.to_lowercase(),
            Self::Transition(transition, _) => match &transition.command {
                Some(name) => name.to_lowercase(),
                None => format!("transition {}", transition.number),
            },
        }
    }

    /// The states in which it does nothing, by id.
    pub fn ignored_in(self) -> &'a [String] {
        match self {
            Self::Command(command, _) => &command.ignored_in,
            Self::Transition(..) => &[],
        }
    }
}

impl Device {
    /// The commands that have a pattern, and then the transitions that follow bits of their own; one that is automatic does
    /// not wait for them.
    pub fn given(&self) -> impl Iterator<Item = Given<'_>> {
        let commands = self.commands.iter();
        let commands =
            commands.filter_map(|command| Some(Given::Command(command, command.pattern.as_ref()?)));
        let own = self.transitions.iter().filter(|one| one.supported && !one.automatic);
        commands.chain(own.filter_map(|one| Some(Given::Transition(one, one.pattern.as_ref()?))))
    }

    /// The transitions that something sets off, by number; of a command those that the device makes.
    pub fn set_off(&self, given: Given<'_>) -> Vec<u8> {
        let is_made =
            |number: &u8| !self.transitions.iter().any(|one| one.number == *number && !one.supported);
        match given {
            Given::Command(command, _) => command.transitions.iter().copied().filter(is_made).collect(),
            Given::Transition(transition, _) => vec![transition.number],
        }
    }

    /// The transitions that events make, the most urgent first.
    pub fn caused(&self) -> Vec<&Transition> {
        let made = self.transitions.iter().filter(|transition| transition.supported);
        let mut caused: Vec<&Transition> = made.filter(|transition| !transition.events.is_empty()).collect();
        caused.sort_by_key(|transition| (transition.events.iter().min(), transition.number));
        caused
    }

    /// Where a transition starts, by id. One that names no state is the start itself, or comes from every state but the
    /// one it ends in and what follows that without a command: no fault leads from a fault to its reaction.
    pub fn origins<'a>(&'a self, transition: &'a Transition) -> Vec<&'a str> {
        if !transition.from.is_empty() {
            return transition.from.iter().map(String::as_str).collect();
        }
        let others = || self.transitions.iter().filter(|other| other.number != transition.number);
        let is_start = others().all(|other| other.to != transition.to && other.number >= transition.number);
        if is_start {
            return Vec::new();
        }
        let leads = |from: &Transition, id: &str| {
            from.automatic && from.from.contains(&transition.to) && from.to == id
        };
        let follows = |id: &str| self.transitions.iter().any(|other| leads(other, id));
        let ids = self.states.iter().map(|state| state.id.as_str());
        ids.filter(|id| *id != transition.to && !follows(id)).collect()
    }

    /// The codes that a master may choose a mode by, ascending: those that fit the object of the mode, which has 8 bits; a
    /// rule reports the others.
    pub fn mode_codes(&self) -> Vec<i8> {
        let modes = self.modes.iter();
        let codes = modes.flat_map(|mode| std::iter::once(mode.code).chain(mode.aliases.iter().copied()));
        let mut codes: Vec<i8> = codes.filter_map(|code| i8::try_from(code).ok()).collect();
        codes.sort_unstable();
        codes.dedup();
        codes
    }
}
