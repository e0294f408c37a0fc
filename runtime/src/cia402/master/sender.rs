//! The controlwords that go out.

use super::Timing;
use super::route::Road;
use crate::cia402::{Command, Events, State, StateSet};

/// Remembers what was sent, so that edges happen, and so that no word reaches the drive in a state which it is wrong
/// for: the answer to a word comes cycles later.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sender {
    word: u16,
    /// How many cycles `word` was sent for.
    cycles: u16,
    /// The word whose edge was given in this state.
    tried: Option<u16>,
    seen: Option<State>,
    /// Whether the drive has had `word`.
    has_arrived: bool,
    /// Whether the drive had had all words before, when `word` followed them.
    is_alone: bool,
    /// Where the drive may be by the words that are under way.
    possible: StateSet,
}

impl Sender {
    pub(super) const fn new() -> Self {
        Self {
            word: 0,
            cycles: 0,
            tried: None,
            seen: None,
            has_arrived: true,
            is_alone: true,
            possible: StateSet::ALL,
        }
    }

    /// Another request: no edge of an earlier one counts for it.
    pub(super) const fn restart(&mut self) {
        self.tried = None;
    }

    /// The word while the state is not known: that one, or the last again, without a new edge.
    pub(super) fn send_unseen(&mut self, word: Option<u16>) -> u16 {
        match word.filter(|word| *word != self.word) {
            Some(word) => {
                self.change(word);
                self.possible = StateSet::ALL;
                word
            }
            None => self.repeat(),
        }
    }

    /// The next word, for the command if there is one, or else for staying in the state.
    pub(super) fn send(
        &mut self,
        road: &Road,
        timing: Timing,
        state: State,
        command: Option<&Command>,
    ) -> u16 {
        self.settle(road, timing, state);
        let wanted = match command {
            Some(command) => self.wanted(timing, command),
            None => road.holding(state),
        };
        if wanted == self.word || self.has_to_wait(road, state, wanted) {
            return self.repeat();
        }
        self.change(wanted);
        self.possible = follow(road, self.possible.with(state), wanted);
        wanted
    }

    /// Whether a word might come to the drive in a state that it is wrong for, while the last word is still right.
    fn has_to_wait(&self, road: &Road, state: State, wanted: u16) -> bool {
        let is_right = |word: u16, state: State| road.machine.allows(state, (self.word, word));
        let is_wrong = !self.possible.with(state).iter().all(|possible| is_right(wanted, possible));
        is_wrong && is_right(self.word, state)
    }

    const fn change(&mut self, word: u16) {
        self.is_alone = self.has_arrived;
        (self.word, self.cycles, self.has_arrived) = (word, 1, false);
    }

    const fn repeat(&mut self) -> u16 {
        self.cycles = self.cycles.saturating_add(1);
        self.word
    }

    /// What the drive may have come to, once more is known.
    fn settle(&mut self, road: &Road, timing: Timing, state: State) {
        let before = self.seen.replace(state);
        if before != Some(state) {
            self.tried = None;
        }
        // the one word that is under way leads here, so it has come; at first, none of this master is under way
        let leads = |before| self.is_alone && after(road, before, self.word) == Some(state);
        let has_come = before.is_none_or(|before| before != state && leads(before));
        if has_come || self.cycles > timing.round_trip {
            self.has_arrived = true;
            self.possible = StateSet::NONE.with(state);
        } else if before != Some(state) {
            self.possible = follow(road, self.possible.with(state), self.word);
        }
    }

    /// The word of a command; before an edge, and again if nothing comes of it, the word that prepares the edge.
    fn wanted(&mut self, timing: Timing, command: &Command) -> u16 {
        let given = command.apply(0);
        let prepared = command.prepare(given);
        let Some(edge) = command.edge else { return given };
        // a reset is a pulse; other bits have to stay
        let is_reset = command.triggers(15);
        let (up, down) =
            if is_reset { (timing.round_trip, timing.resend) } else { (timing.resend, timing.round_trip) };
        let is_tried = self.tried == Some(given);
        let waits = |word: u16, cycles: u16| is_tried && self.word == word && self.cycles < cycles;
        if waits(given, up) {
            given
        } else if waits(prepared, down) || !edge.happened(self.word, given) {
            prepared
        } else {
            self.tried = Some(given);
            given
        }
    }
}

/// The states that a word may have led to.
fn follow(road: &Road, states: StateSet, word: u16) -> StateSet {
    states.iter().filter_map(|state| after(road, state, word)).fold(states, StateSet::with)
}

fn after(road: &Road, state: State, word: u16) -> Option<State> {
    road.machine.step(state, (!word, word), Events::NONE).map(|step| step.to)
}
