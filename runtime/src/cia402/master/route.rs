//! The way from state to state.

use crate::cia402::{Command, Events, Machine, State, StateSet, Transition};

/// How the master leads a drive out of the state operation enabled (CiA 402, transitions 5 and 11).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Leave {
    /// By disable operation, transition 5, which ramps down unless 0x605C says otherwise (CiA 402).
    #[default]
    DisableOperation,
    /// By a quick stop, transition 11: for axes that gravity pulls, which a brake holds (Pilz 1005347, 6.5.1).
    QuickStop,
}

/// The next transition on the shortest way, and how many are left with it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Leg {
    pub(super) left: u8,
    pub(super) next: Option<&'static Transition>,
}

/// What a way may lead through.
#[derive(Debug, Clone, Copy)]
pub(super) struct Road {
    pub(super) machine: &'static Machine,
    pub(super) leave: Leave,
    pub(super) fault_reset: bool,
}

impl Road {
    /// The way from one state to another. It leaves operation enabled as it should, if there is such a way.
    pub(super) fn leg(&self, from: State, to: State) -> Option<Leg> {
        // no way leads through operation enabled, lest a drive be enabled only to be disabled again
        let passes =
            |transition: &Transition| transition.to != State::OperationEnabled || transition.to == to;
        let any = |transition: &Transition| passes(transition) && self.is_open(transition, from);
        let gentle = |transition: &Transition| any(transition) && !self.is_rough(transition);
        self.shortest(from, to, gentle).or_else(|| self.shortest(from, to, any))
    }

    /// The command that makes a transition, and the words that give it; `None` if the drive makes it by itself.
    pub(super) fn command(&self, transition: &Transition, state: State) -> Option<&'static Command> {
        let makes = |command: &&Command| {
            let word = command.apply(0);
            let step = self.machine.step(state, (command.prepare(word), word), Events::NONE);
            step.is_some_and(|step| step.number == transition.number)
        };
        let mut given = self.machine.commands.iter().filter(|one| one.triggers(transition.number));
        given.find(makes)
    }

    /// The controlword that keeps a drive in a state: the first command that leads there. Where none does, no bit is
    /// set, which asks for nothing.
    pub(super) fn holding(&self, state: State) -> u16 {
        let stays = |word: &u16| self.machine.step(state, (*word, *word), Events::NONE).is_none();
        let leading = self.machine.commands.iter().filter(|command| {
            self.machine
                .reached_by(command)
                .any(|transition| transition.to == state && transition.number != 15)
        });
        leading.map(|command| command.apply(0)).find(stays).unwrap_or(0)
    }

    fn shortest(&self, from: State, to: State, open: impl Fn(&Transition) -> bool) -> Option<Leg> {
        if from == to {
            return Some(Leg { left: 0, next: None });
        }
        let mut reached = StateSet::NONE.with(to);
        (1..=State::ALL.len()).zip(1_u8..).find_map(|(_, left)| {
            let entering =
                || self.machine.transitions.iter().filter(|one| reached.contains(one.to) && open(one));
            let next = entering().find(|transition| transition.from.contains(from));
            reached = entering().fold(reached, |set, transition| set.and(transition.from));
            next.map(|next| Leg { left, next: Some(next) })
        })
    }

    /// Whether the master may count on a transition: by a command, or because the drive makes it in good order.
    fn is_open(&self, transition: &Transition, from: State) -> bool {
        const ORDERLY: Events =
            Events::INITIALISED.and(Events::FAULT_REACTION_OVER).and(Events::QUICK_STOP_OVER);
        let number = transition.number;
        let commanded = || self.machine.commands.iter().any(|command| command.triggers(number));
        let orderly = || {
            let mut conditions = self.machine.conditions.iter().filter(|one| one.transition == number);
            conditions.any(|condition| condition.causes.any(ORDERLY))
        };
        match number {
            13 => false,
            // on some devices a fault reset leads out of other states too, which is no way to go (C887T0011, p. 12)
            15 => self.fault_reset && matches!(from, State::Fault | State::FaultReactionActive),
            _ => commanded() || orderly(),
        }
    }

    /// Whether a transition leaves operation enabled otherwise than it should.
    fn is_rough(&self, transition: &Transition) -> bool {
        match self.leave {
            Leave::DisableOperation => matches!(transition.number, 8 | 9),
            Leave::QuickStop => matches!(transition.number, 5 | 8 | 9),
        }
    }
}
