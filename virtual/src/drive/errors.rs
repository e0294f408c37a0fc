//! What a drive says when something is wrong: error register, error code, emergencies.

use std::collections::VecDeque;

use devc_runtime::coe::Emergency;

use super::model::Facts;

/// As many emergencies as wait for the mailbox; later ones are lost, as in a device.
const MOST: usize = 16;

/// The error register, 0x1001, and the emergencies that no master has read yet.
#[derive(Debug, Clone, Default)]
pub(super) struct Errors {
    pub(super) register: u8,
    waiting: VecDeque<Emergency>,
}

impl Errors {
    /// A fault with this code.
    pub(super) fn raise(&mut self, code: u16, facts: &Facts) {
        self.register |= register(code, facts);
        self.say(code);
    }

    /// All faults are gone.
    pub(super) fn clear(&mut self) {
        if std::mem::take(&mut self.register) != 0 {
            self.say(0);
        }
    }

    /// The emergency that waits longest, which is taken for said.
    pub(super) fn next(&mut self) -> Option<Emergency> {
        self.waiting.pop_front()
    }

    /// Forgets what waits: the mailbox begins anew.
    pub(super) fn forget(&mut self) {
        self.waiting.clear();
    }

    fn say(&mut self, code: u16) {
        if self.waiting.len() < MOST {
            self.waiting.push_back(Emergency { code, register: self.register, data: [0; 5] });
        }
    }
}

/// The bits of the error register that come with a code: those of the description, or by the class of the code (CiA 301,
/// error register and emergency error codes).
fn register(code: u16, facts: &Facts) -> u8 {
    let known = facts.errors.iter().filter(|(first, last, _)| (*first..=*last).contains(&code));
    let known = known.min_by_key(|(first, last, _)| last.saturating_sub(*first));
    known.and_then(|(_, _, register)| *register).unwrap_or(match code >> 8 {
        0x20..=0x2F => 0x03,
        0x30..=0x3F => 0x05,
        0x40..=0x4F => 0x09,
        0x80..=0x82 => 0x11,
        0x83..=0x8F => 0x21,
        _ => 0x81,
    })
}
