//! How a drive is brought into operation: the words to write, from each state.
//!
//! Only commands that are described are words to be shown: the bits of a transition of its own leave others open, and with
//! these at 0 a word may be another command.

use std::collections::{BTreeMap, VecDeque};

use crate::model::{Command, Device};

/// The state in which a drive follows its set values.
const GOAL: &str = "operation-enabled";

/// The way from a state.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Way {
    /// The name of the state.
    pub(super) from: String,
    /// What to do.
    pub(super) steps: Vec<Step>,
}

/// A step of a way.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Step {
    /// What the controlword has to be, and what that is called; none where the drive goes on by itself.
    pub(super) word: Option<(u16, String)>,
    /// The bits that have to rise: they are 0 in the word before.
    pub(super) rising: u16,
    /// The name of the state that it leads to.
    pub(super) to: String,
}

/// The shortest way from each state from which there is one.
pub(super) fn ways(device: &Device) -> Vec<Way> {
    let next = towards(device);
    let name = |id: &str| {
        let state = device.states.iter().find(|state| state.id == id);
        state.map_or_else(|| id.to_owned(), |state| state.name.clone())
    };
    let way = |from: &str| {
        let mut steps = Vec::new();
        let mut at = from;
        while let Some((command, to)) = next.get(at) {
            let pattern = command.and_then(|command| Some((command.pattern.as_ref()?, command)));
            steps.push(Step {
                word: pattern.map(|(pattern, command)| (pattern.value(), command.name.clone())),
                rising: pattern.map_or(0, |(pattern, _)| pattern.rising()),
                to: name(to),
            });
            at = to;
        }
        Way { from: name(from), steps }
    };
    let ways = device.states.iter().map(|state| way(&state.id));
    ways.filter(|way| !way.steps.is_empty()).collect()
}

/// The first step from each state: what asks for it, and where it leads to.
fn towards(device: &Device) -> BTreeMap<&str, (Option<&Command>, &str)> {
    let mut next = BTreeMap::new();
    let mut open = VecDeque::from([GOAL]);
    while let Some(to) = open.pop_front() {
        let leading =
            device.transitions.iter().filter(|transition| transition.supported && transition.to == to);
        for transition in leading {
            let asks = |command: &&Command| {
                command.pattern.is_some() && command.transitions.contains(&transition.number)
            };
            let command = device.commands.iter().find(asks);
            if command.is_none() && !transition.automatic {
                continue;
            }
            for from in transition.from.iter().map(String::as_str) {
                if from != GOAL && !next.contains_key(from) {
                    next.insert(from, (command, to));
                    open.push_back(from);
                }
            }
        }
    }
    next
}
