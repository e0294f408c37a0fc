//! Names that a language takes.

use super::Keywords;
use crate::emit::identifier::{Claimed, snake};

/// The most characters of a name; compilers of C may look no further.
const LONGEST: usize = 63;

/// The names of a program.
#[derive(Debug)]
pub(super) struct Names {
    keywords: Keywords,
    /// The most characters of a name behind the prefix.
    room: usize,
    global: Claimed,
}

/// What every program has a name for, besides what is described.
const RESERVED: &[&str] = &[
    "vendor_id",
    "product_code",
    "revision",
    "mode",
    "state",
    "state_of",
    "state_unknown",
    "error_name",
    "al_status_name",
    "sdo_write",
];

/// Room for what is put behind a name: `_unpack`, or a number.
const TAIL: usize = 8;

impl Names {
    /// No names yet but those that every program has.
    pub(super) fn new(keywords: Keywords, prefix: &str) -> Self {
        let room = LONGEST.saturating_sub(prefix.len() + 1 + TAIL).max(2 * TAIL);
        Self { keywords, room, global: Claimed::with(RESERVED) }
    }

    /// A name that is unique in the program, made of the parts. The prefix comes in front, so that it is no keyword.
    pub(super) fn global(&mut self, parts: &[&str]) -> String {
        claim(&mut self.global, &snake(&parts.join("-")), self.room)
    }

    /// Takes the names that are made of one by something behind it.
    pub(super) fn reserve(&mut self, global: &str, tails: &[&str]) {
        for tail in tails {
            let name = format!("{global}_{tail}");
            self.global.claim(name.clone(), |number| format!("{name}_{number}"));
        }
    }

    /// A namespace within the program.
    pub(super) fn siblings(&self) -> Siblings {
        Siblings { keywords: self.keywords, taken: Claimed::default() }
    }
}

/// Names that are told apart among themselves.
#[derive(Debug)]
pub(super) struct Siblings {
    keywords: Keywords,
    taken: Claimed,
}

impl Siblings {
    /// The name of an id.
    pub(super) fn claim(&mut self, id: &str) -> String {
        let name = match snake(id) {
            name if name.is_empty() => "unnamed".to_owned(),
            name if name.starts_with(|c: char| c.is_ascii_digit()) => format!("n{name}"),
            name if self.keywords.iter().any(|word| name.eq_ignore_ascii_case(word)) => format!("{name}_"),
            name => name,
        };
        claim(&mut self.taken, &name, LONGEST)
    }
}

/// The name, cut where it is too long, with a number where it is taken.
fn claim(taken: &mut Claimed, name: &str, room: usize) -> String {
    let cut = |room| name.get(..room).map_or(name, |cut| cut.trim_end_matches('_'));
    taken.claim(cut(room).to_owned(), |number| format!("{}_{number}", cut(room.saturating_sub(TAIL))))
}
