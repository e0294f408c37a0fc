//! The state machine of a device, as data.

use core::fmt;

use super::{Command, Condition, Events, Modes, State, StatePatterns, Transition};

/// What a device's description says about its state machine (CiA 402, PDS FSA): both sides run on it.
///
/// ```
/// use devc_runtime::cia402::{Cause, Events, State, generic};
///
/// // the profile itself; a generated module has a constant like it
/// let step = generic::MACHINE.step(State::SwitchOnDisabled, (0x0000, 0x0006), Events::NONE).unwrap();
/// assert_eq!((step.number, step.to), (2, State::ReadyToSwitchOn));
/// assert_eq!(step.to_string(), "transition 2, switch on disabled to ready to switch on, by shutdown");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Machine {
    /// How the statusword shows the states.
    pub states: StatePatterns,
    /// The commands. A device that follows single bits has one for each transition that a bit makes (S700, 3.4.2).
    pub commands: &'static [Command],
    /// The transitions that the device supports.
    pub transitions: &'static [Transition],
    /// What else they depend on; where several causes hold, the first in the list that leads out of the state.
    pub conditions: &'static [Condition],
    /// What a command does that leads nowhere.
    pub refusal: Refusal,
    /// The modes of operation.
    pub modes: Modes,
}

/// What the device does with a command, or a change of mode, that is not allowed (CiA 402; C887T0011, p. 12).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Refusal {
    /// Nothing (CiA 402).
    Ignored,
    /// It makes transition 13, as for any fault (C887T0011, p. 12).
    Fault,
}

/// A transition that is made (CiA 402, PDS FSA transitions).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Step {
    /// The number of the transition.
    pub number: u8,
    /// The state before.
    pub from: State,
    /// The state after.
    pub to: State,
    /// Why.
    pub cause: Cause,
}

/// Why a transition is made (CiA 402, PDS FSA transitions: event or command).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cause {
    /// A command, by its name.
    Command(&'static str),
    /// Events that need no command.
    Events(Events),
    /// A controlword that is no command here, on a device that takes that for a fault.
    Refused {
        /// The word.
        controlword: u16,
    },
}

impl Machine {
    /// What the drive does in `state` when the controlword goes from the first of the words to the second (CiA 402, PDS
    /// FSA transitions).
    ///
    /// One transition at most: each state lasts a cycle, so that the master can see it.
    #[inline]
    pub fn step(&self, state: State, controlwords: (u16, u16), events: Events) -> Option<Step> {
        self.by_event(state, events)
            .or_else(|| self.by_command(state, controlwords, events))
            .or_else(|| self.by_refusal(state, controlwords))
    }

    /// The transition with that number, if the device supports it (CiA 402, PDS FSA transitions).
    #[inline]
    pub fn transition(&self, number: u8) -> Option<&'static Transition> {
        self.transitions.iter().find(|transition| transition.number == number)
    }

    /// Whether a controlword is a command that the drive takes in `state`: it leads on, asks for what is, or is ignored
    /// (CiA 402, PDS FSA).
    ///
    /// Before it is ready, and in a fault and its reaction, a drive looks for nothing but a fault reset, so that no
    /// word is wrong there. A word that gives no command, such as a fault reset that is held, is none either.
    #[inline]
    pub fn allows(&self, state: State, (previous, current): (u16, u16)) -> bool {
        let mut given = self.commands.iter().filter(|command| command.is_given(previous, current)).peekable();
        is_deaf(state)
            || given.peek().is_none()
            || given.any(|command| command.ignored_in.contains(state) || self.fits(command, state))
    }

    /// Whether a command leads out of `state`, or asks for it.
    pub(super) fn fits(&self, command: &Command, state: State) -> bool {
        self.reached_by(command).any(|transition| transition.from.contains(state) || transition.to == state)
    }

    /// The transitions that a command may make.
    pub(super) fn reached_by<'a>(
        &'a self,
        command: &'a Command,
    ) -> impl Iterator<Item = &'static Transition> + 'a {
        self.transitions.iter().filter(|transition| command.triggers(transition.number))
    }

    fn by_event(&self, state: State, events: Events) -> Option<Step> {
        self.conditions.iter().find_map(|condition| {
            let causes = condition.causes.common(events);
            let transition = self.transition(condition.transition).filter(|_| !causes.is_empty())?;
            step(transition, state, Cause::Events(causes))
        })
    }

    fn by_command(&self, state: State, (previous, current): (u16, u16), events: Events) -> Option<Step> {
        let given = self.commands.iter().filter(|command| command.is_given(previous, current));
        given
            .filter(|command| !command.ignored_in.contains(state))
            .flat_map(|command| self.reached_by(command).map(move |transition| (command, transition)))
            .filter(|(_, transition)| !self.is_hindered(transition.number, events))
            .find_map(|(command, transition)| step(transition, state, Cause::Command(command.name)))
    }

    fn by_refusal(&self, state: State, controlwords: (u16, u16)) -> Option<Step> {
        if self.refusal == Refusal::Ignored || self.allows(state, controlwords) {
            return None;
        }
        step(self.transition(13)?, state, Cause::Refused { controlword: controlwords.1 })
    }

    fn is_hindered(&self, number: u8, events: Events) -> bool {
        let mut conditions = self.conditions.iter().filter(|condition| condition.transition == number);
        conditions.any(|condition| condition.hinders.any(events))
    }
}

/// The states in which no command counts but fault reset.
const fn is_deaf(state: State) -> bool {
    matches!(state, State::NotReadyToSwitchOn | State::FaultReactionActive | State::Fault)
}

fn step(transition: &Transition, from: State, cause: Cause) -> Option<Step> {
    let leads = transition.from.contains(from);
    leads.then_some(Step { number: transition.number, from, to: transition.to, cause })
}

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "transition {}, {} to {}, by ", self.number, self.from, self.to)?;
        match self.cause {
            Cause::Command(name) => f.write_str(name),
            Cause::Events(events) => write!(f, "{events}"),
            Cause::Refused { controlword } => write!(f, "controlword 0x{controlword:04X}, not allowed here"),
        }
    }
}
