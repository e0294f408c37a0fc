//! What the bits of an object access mean, by the table of ETG.1000.6 for "get entry description".

use devc_runtime::sdo::{AbortCode, Access, CommunicationState};

/// Each state with its bit for reading and its bit for writing, and the word for it.
const STATES: [(CommunicationState, u16, u16, &str); 3] = [
    (CommunicationState::PreOperational, 1 << 0, 1 << 3, "pre-op"),
    (CommunicationState::SafeOperational, 1 << 1, 1 << 4, "safe-op"),
    (CommunicationState::Operational, 1 << 2, 1 << 5, "op"),
];

/// Whether any bit is set.
fn has(access: u16, bits: u16) -> bool {
    (0..16).any(|bit| access >> bit & 1 == 1 && bits >> bit & 1 == 1)
}

#[test]
fn an_entry_is_read_and_written_in_the_states_of_its_bits() {
    for access in 0..1 << 10 {
        for (state, read, write, _) in STATES {
            let expected = |bit, all, never| match (has(access, bit), has(access, all)) {
                (true, _) => Ok(()),
                (false, true) => Err(AbortCode::DEVICE_STATE),
                (false, false) => Err(never),
            };
            let rights = Access(access);
            assert_eq!(rights.check_read(state), expected(read, 0x07, AbortCode::WRITE_ONLY), "{access:#x}");
            assert_eq!(rights.check_write(state), expected(write, 0x38, AbortCode::READ_ONLY), "{access:#x}");
        }
    }
}

#[test]
fn rights_are_named_with_the_states_of_those_for_writing() {
    for access in 0..1 << 10 {
        let states = STATES.iter().filter(|(_, _, write, _)| has(access, *write));
        let states: Vec<&str> = states.map(|(.., name)| *name).collect();
        let plain = match (has(access, 0x07), states.is_empty()) {
            (true, false) => "rw",
            (true, true) => "ro",
            (false, false) => "wo",
            (false, true) => "none",
        };
        let states = match states.len() {
            0 | 3 => String::new(),
            _ => format!(" ({})", states.join(", ")),
        };
        assert_eq!(Access(access).to_string(), format!("{plain}{states}"), "{access:#x}");
    }
}

#[test]
fn rights_that_both_have_are_had_once() {
    for (one, other) in [(0x07, 0x38), (0x07, 0x07), (0x3F, 0x41)] {
        let both = Access(one).and(Access(other));
        assert!(both.includes(Access(one)) && both.includes(Access(other)), "{both:?}");
        assert!((0..16).all(|bit| has(both.0, 1 << bit) == (has(one, 1 << bit) || has(other, 1 << bit))));
    }
    assert!(!Access(0x07).includes(Access(0x0F)));
}
