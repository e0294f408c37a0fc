//! How a drive is brought into operation: the words to write, from each state.
//!
//! Only commands that are described are whole words: the bits of a transition of its own leave others open, and with these at
//! 0 a word may be another command. So these are shown as bits.

use std::collections::{BTreeMap, VecDeque};
use std::fmt;

use crate::model::{Command, Device, Pattern, Transition};

/// The state in which a drive follows its set values.
const GOAL: &str = "operation-enabled";

/// The way from a state.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Way {
    /// The id of the state.
    pub(super) id: String,
    /// The name of the state.
    pub(super) from: String,
    /// What to do.
    pub(super) steps: Vec<Step>,
}

/// A step of a way.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Step {
    /// What the controlword has to be, and what that is called; none where the drive goes on by itself.
    word: Option<(Written, String)>,
    /// The name of the state that it leads to.
    to: String,
}

/// What is written into the controlword.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Written {
    /// A word, and which bits of it are 0 before.
    Word(u16, u16),
    /// Bits that are given, with others left open.
    Bits(Pattern),
}

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.word {
            None => return write!(f, "wait for {}", self.to),
            Some((Written::Word(word, 0), name)) => write!(f, "0x{word:04X} ({name})")?,
            Some((Written::Word(word, rising), name)) => {
                write!(f, "0x{:04X}, then 0x{word:04X} ({name})", word & !rising)?;
            }
            Some((Written::Bits(bits), name)) if name.is_empty() => write!(f, "bits {bits}")?,
            Some((Written::Bits(bits), name)) => write!(f, "bits {bits} ({name})")?,
        }
        write!(f, ": {}", self.to)
    }
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
        while let Some((asked, to)) = next.get(at) {
            steps.push(Step { word: asked.as_ref().map(Asked::word), to: name(to) });
            at = to;
        }
        Way { id: from.to_owned(), from: name(from), steps }
    };
    let ways = device.states.iter().map(|state| way(&state.id));
    ways.filter(|way| !way.steps.is_empty()).collect()
}

/// What asks for a transition.
enum Asked<'a> {
    Command(&'a Command, &'a Pattern),
    Bits(&'a Transition, &'a Pattern),
}

impl Asked<'_> {
    fn word(&self) -> (Written, String) {
        match self {
            Self::Command(command, bits) => {
                (Written::Word(bits.value(), bits.rising()), command.name.clone())
            }
            Self::Bits(transition, bits) => {
                (Written::Bits((*bits).clone()), transition.command.clone().unwrap_or_default())
            }
        }
    }
}

/// What asks for a transition: a command first; none if nothing does.
fn asked<'a>(device: &'a Device, transition: &'a Transition) -> Option<Asked<'a>> {
    let mut commands =
        device.commands.iter().filter(|command| command.transitions.contains(&transition.number));
    let command = commands.find_map(|command| Some(Asked::Command(command, command.pattern.as_ref()?)));
    let own = || transition.pattern.as_ref().filter(|_| !transition.automatic);
    command.or_else(|| own().map(|bits| Asked::Bits(transition, bits)))
}

/// The first step from each state: what asks for it, and where it leads to.
fn towards(device: &Device) -> BTreeMap<&str, (Option<Asked<'_>>, &str)> {
    let mut next = BTreeMap::new();
    let mut open = VecDeque::from([GOAL]);
    while let Some(to) = open.pop_front() {
        let supported = device.transitions.iter().filter(|transition| transition.supported);
        for transition in supported.filter(|transition| transition.to == to) {
            if asked(device, transition).is_none() && !transition.automatic {
                continue;
            }
            for from in transition.from.iter().map(String::as_str) {
                if from != GOAL && !next.contains_key(from) {
                    next.insert(from, (asked(device, transition), to));
                    open.push_back(from);
                }
            }
        }
    }
    next
}
