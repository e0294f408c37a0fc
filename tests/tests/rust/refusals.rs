//! What a device refuses, each with the code that the standards have for it.

use devc_runtime::coe::{Mailbox, Request};
use devc_runtime::object::Address;
use devc_runtime::sdo::AbortCode;
use devc_runtime::sdo::CommunicationState::{
    self, Operational as O, PreOperational as P, SafeOperational as S,
};

use crate::mapped::{Dictionary, ask, download, mailbox, write};

/// A write: to which index and subindex, and what.
type Write = (u16, u8, &'static [u8]);

/// What comes before, the state, the write that is refused, and the code.
type Case = (&'static [Write], CommunicationState, Write, u32);

/// "Abort SDO transfer" of CiA 301, "SDO abort codes" of ETG.1000.6: what is not there.
const MISSING: &[Case] = &[
    (&[], P, (0x2FFF, 0, &[0]), 0x0602_0000),
    (&[], P, (0x1605, 0, &[0]), 0x0602_0000),
    (&[], P, (0x1A02, 1, &[0; 4]), 0x0602_0000),
    (&[], P, (0x1C14, 0, &[0]), 0x0602_0000),
    (&[], P, (0x2000, 1, &[0]), 0x0609_0011),
    (&[], P, (0x200C, 3, b"abcd"), 0x0609_0011),
    (&[], P, (0x1600, 7, &[0; 4]), 0x0609_0011),
    (&[], P, (0x1601, 2, &[0; 4]), 0x0609_0011),
    (&[], P, (0x1A00, 9, &[0; 4]), 0x0609_0011),
    (&[], P, (0x1C12, 4, &[0; 2]), 0x0609_0011),
];

/// The same clauses, and "object access" of ETG.1000.6: who may write, and when. What process data is made of is written in
/// Pre-Operational (ETG.1020, start-up).
const ACCESS: &[Case] = &[
    (&[], P, (0x2004, 0, &[0; 4]), 0x0601_0002),
    (&[], P, (0x1601, 0, &[0]), 0x0601_0002),
    (&[], P, (0x1601, 1, &[0; 4]), 0x0601_0002),
    (&[], P, (0x1A01, 1, &[0; 4]), 0x0601_0002),
    (&[], P, (0x1C00, 1, &[3]), 0x0601_0002),
    (&[], S, (0x200A, 0, &[0; 2]), 0x0800_0022),
    (&[], O, (0x200A, 0, &[0; 2]), 0x0800_0022),
    (&[], P, (0x200B, 0, &[0; 2]), 0x0800_0022),
    (&[], S, (0x200B, 0, &[0; 2]), 0x0800_0022),
    (&[], S, (0x1600, 0, &[0]), 0x0800_0022),
    (&[], O, (0x1600, 0, &[0]), 0x0800_0022),
    (&[(0x1600, 0, &[0])], S, (0x1600, 1, &[0x10, 0, 0x03, 0x20]), 0x0800_0022),
    (&[(0x1A00, 0, &[0])], O, (0x1A00, 1, &[0x20, 0, 0x04, 0x20]), 0x0800_0022),
    (&[], S, (0x1C12, 0, &[0]), 0x0800_0022),
    (&[], O, (0x1C13, 0, &[0]), 0x0800_0022),
    (&[(0x1C12, 0, &[0])], O, (0x1C12, 1, &[0x02, 0x16]), 0x0800_0022),
];

/// The same clauses: lengths and bounds.
const VALUES: &[Case] = &[
    (&[], P, (0x2003, 0, &[0; 3]), 0x0607_0012),
    (&[], P, (0x2003, 0, &[0]), 0x0607_0013),
    (&[], P, (0x2005, 0, b"abcde"), 0x0607_0012),
    (&[], P, (0x1600, 0, &[0; 2]), 0x0607_0012),
    (&[(0x1600, 0, &[0])], P, (0x1600, 1, &[0; 2]), 0x0607_0013),
    (&[(0x1C12, 0, &[0])], P, (0x1C12, 1, &[0; 4]), 0x0607_0012),
    (&[], P, (0x2001, 0, &[8]), 0x0609_0031),
    (&[], P, (0x2008, 0, &[0xE9, 0x03]), 0x0609_0031),
    (&[], P, (0x2008, 0, &[0xF5, 0xFF]), 0x0609_0032),
    (&[], P, (0x2009, 0, &[0, 0, 0x40, 0x40]), 0x0609_0031),
    (&[], P, (0x2009, 0, &[0, 0, 0xC0, 0x7F]), 0x0609_0030),
];

const CLEAR: &[Write] = &[(0x1600, 0, &[0])];
const CLEAR_TX: &[Write] = &[(0x1A00, 0, &[0])];
const TWO_BYTES: &[u8] = &[0x10, 0, 0x03, 0x20];
const THREE_BYTES: &[u8] = &[0x18, 0, 0x02, 0x20];

/// "PDO mapping parameter" of CiA 301: in step 2 subindex 0 is set to 0, in step 3 objects are mapped (0x06040041), and in step
/// 4 subindex 0 is set to their number (0x06020000, 0x06040042).
const MAPPING: &[Case] = &[
    (&[], P, (0x1600, 1, TWO_BYTES), 0x0601_0003),
    (&[], P, (0x1600, 2, TWO_BYTES), 0x0601_0003),
    (&[], P, (0x1A00, 1, &[0; 4]), 0x0601_0003),
    // no such object, no such subindex
    (CLEAR, P, (0x1600, 1, &[0x10, 0, 0xFF, 0x2F]), 0x0604_0041),
    (CLEAR, P, (0x1600, 1, &[0x01, 1, 0x00, 0x20]), 0x0604_0041),
    // not mappable: at all, this way
    (CLEAR, P, (0x1600, 1, &[0x20, 0, 0x06, 0x20]), 0x0604_0041),
    (CLEAR, P, (0x1600, 1, &[0x20, 1, 0x18, 0x10]), 0x0604_0041),
    (CLEAR, P, (0x1600, 1, &[0x20, 1, 0x00, 0x16]), 0x0604_0041),
    (CLEAR, P, (0x1600, 1, &[0x20, 0, 0x04, 0x20]), 0x0604_0041),
    (CLEAR_TX, P, (0x1A00, 1, TWO_BYTES), 0x0604_0041),
    (CLEAR_TX, P, (0x1A00, 1, &[0x08, 0, 0x07, 0x20]), 0x0604_0041),
    // another width
    (CLEAR, P, (0x1600, 1, &[0x08, 0, 0x03, 0x20]), 0x0604_0041),
    (CLEAR, P, (0x1600, 1, &[0x00, 0, 0x03, 0x20]), 0x0604_0041),
    (CLEAR, P, (0x1600, 1, &[0x08, 0, 0x00, 0x20]), 0x0604_0041),
    (CLEAR, P, (0x1600, 1, &[0x04, 0, 0x01, 0x20]), 0x0604_0041),
    (CLEAR, P, (0x1600, 1, &[0x20, 0, 0x02, 0x20]), 0x0604_0041),
    (CLEAR_TX, P, (0x1A00, 1, &[0x10, 0, 0x04, 0x20]), 0x0604_0041),
    // a gap has no subindex
    (CLEAR, P, (0x1600, 1, &[0x08, 1, 0x00, 0x00]), 0x0604_0041),
    // more than there are, more than is mapped
    (&[], P, (0x1600, 0, &[7]), 0x0604_0042),
    (&[], P, (0x1600, 0, &[255]), 0x0604_0042),
    (&[], P, (0x1A00, 0, &[9]), 0x0604_0042),
    (&[], P, (0x1600, 0, &[2]), 0x0602_0000),
    (&[(0x1600, 0, &[0]), (0x1600, 1, &[0; 4])], P, (0x1600, 0, &[1]), 0x0602_0000),
    // 9 bytes of 8, and a gap of 255 bits
    (
        &[(0x1600, 0, &[0]), (0x1600, 1, THREE_BYTES), (0x1600, 2, THREE_BYTES), (0x1600, 3, THREE_BYTES)],
        P,
        (0x1600, 0, &[3]),
        0x0604_0042,
    ),
    (&[(0x1600, 0, &[0]), (0x1600, 1, &[0xFF, 0, 0, 0])], P, (0x1600, 0, &[1]), 0x0604_0042),
];

const NONE: &[Write] = &[(0x1C12, 0, &[0])];

/// "Sync manager PDO assignment" of ETG.1000.6, with the codes of its "SDO abort codes".
const ASSIGNMENT: &[Case] = &[
    (&[], P, (0x1C12, 1, &[0x02, 0x16]), 0x0601_0003),
    (&[], P, (0x1C13, 1, &[0x01, 0x1A]), 0x0601_0003),
    // no PDO: not there, of the other direction, another object
    (NONE, P, (0x1C12, 1, &[0x05, 0x16]), 0x0609_0030),
    (NONE, P, (0x1C12, 1, &[0x00, 0x1A]), 0x0609_0030),
    (&[(0x1C13, 0, &[0])], P, (0x1C13, 1, &[0x00, 0x16]), 0x0609_0030),
    (NONE, P, (0x1C12, 1, &[0x03, 0x20]), 0x0609_0030),
    (NONE, P, (0x1C12, 1, &[0x12, 0x1C]), 0x0609_0030),
    (&[(0x1C12, 0, &[0]), (0x1C12, 1, &[0; 2])], P, (0x1C12, 0, &[1]), 0x0609_0030),
    // more than there can be
    (NONE, P, (0x1C12, 0, &[4]), 0x0604_0042),
    (&[], P, (0x1C13, 0, &[3]), 0x0604_0042),
    // one excludes the other; one twice; one that has to be there is not
    (
        &[
            (0x1C12, 0, &[0]),
            (0x1C12, 1, &[0x02, 0x16]),
            (0x1C12, 2, &[0x01, 0x16]),
            (0x1C12, 3, &[0x00, 0x16]),
        ],
        P,
        (0x1C12, 0, &[3]),
        0x0604_0043,
    ),
    (&[(0x1C12, 0, &[0]), (0x1C12, 2, &[0x02, 0x16])], P, (0x1C12, 0, &[2]), 0x0604_0043),
    (&[(0x1C12, 0, &[0]), (0x1C12, 1, &[0x03, 0x16])], P, (0x1C12, 0, &[1]), 0x0604_0043),
    // 16 bytes of 14: 0x1604 with three values of four bytes, 0x1603 and 0x1602
    (
        &[
            (0x1604, 0, &[0]),
            (0x1604, 1, &[0x20, 0, 0x09, 0x20]),
            (0x1604, 2, &[0x20, 0, 0x05, 0x20]),
            (0x1604, 3, &[0x20, 0, 0x09, 0x20]),
            (0x1604, 0, &[3]),
            (0x1C12, 0, &[0]),
            (0x1C12, 1, &[0x02, 0x16]),
            (0x1C12, 2, &[0x03, 0x16]),
            (0x1C12, 3, &[0x04, 0x16]),
        ],
        P,
        (0x1C12, 0, &[3]),
        0x0604_0042,
    ),
];

/// "Complete access" of ETG.1000.6.
const WHOLE: &[Case] = &[
    (&[], P, (0x2FFF, 0, &[0]), 0x0602_0000),
    (&[], P, (0x1600, 2, &[0; 4]), 0x0609_0011),
    (&[], P, (0x2003, 0, &[0; 2]), 0x0601_0000),
    (&[], P, (0x200C, 0, &[1, 0, 1, 2, 3, 4]), 0x0601_0004),
    (&[], S, (0x1600, 0, &[1, 0, 0x10, 0, 0x03, 0x20]), 0x0800_0022),
    (&[], P, (0x1600, 0, &[2, 0, 0x10, 0, 0x03, 0x20]), 0x0607_0013),
    (&[], P, (0x1600, 0, &[1, 0, 0x20, 0, 0x06, 0x20]), 0x0604_0041),
    (&[], P, (0x1600, 0, &[1, 0, 0xFF, 0, 0, 0]), 0x0604_0042),
    (&[], P, (0x1600, 1, &[0x10, 0, 0x03, 0x20]), 0x0601_0003),
    (&[], P, (0x1C12, 0, &[2, 0, 0x02, 0x16, 0x02, 0x16]), 0x0604_0043),
    (&[], P, (0x1C12, 0, &[1, 0, 0x05, 0x16]), 0x0609_0030),
];

fn refuse(cases: &[Case], is_complete: bool) {
    for (before, state, (index, subindex, data), code) in cases {
        let mut mailbox: Mailbox<Dictionary, (), 64> = mailbox();
        for (index, subindex, data) in *before {
            assert_eq!(
                write(&mut mailbox, (*index, *subindex), data),
                Ok(()),
                "0x{index:04X}:{subindex:02X} {data:02X?}"
            );
        }
        let as_it_was = mailbox.server.values;
        let request = match download((*index, *subindex), data) {
            Request::Download { address, size, data, .. } => {
                Request::Download { address, is_complete, size, data }
            }
            other => other,
        };
        let refused = ask(&mut mailbox, *state, request);
        assert_eq!(refused, Err(AbortCode(*code)), "0x{index:04X}:{subindex:02X} {data:02X?} in {state:?}");
        assert_eq!(mailbox.server.values, as_it_was, "0x{index:04X}:{subindex:02X} is not as it was");
    }
}

#[test]
fn what_is_refused_has_the_code_of_the_standard() {
    let single = [MISSING, ACCESS, VALUES, MAPPING, ASSIGNMENT];
    single.iter().for_each(|cases| refuse(cases, false));
    refuse(WHOLE, true);
    let cases: usize = single.iter().chain([&WHOLE]).map(|cases| cases.len()).sum();
    assert!(cases >= 60, "{cases} cases");
}

/// "Abort SDO transfer": what cannot be read.
#[test]
fn what_cannot_be_read_has_the_code_of_the_standard() {
    for ((index, subindex), is_complete, code) in [
        ((0x2007, 0), false, 0x0601_0001),
        ((0x2FFF, 0), false, 0x0602_0000),
        ((0x1605, 0), false, 0x0602_0000),
        ((0x1600, 7), false, 0x0609_0011),
        ((0x2003, 0), true, 0x0601_0000),
        ((0x1600, 2), true, 0x0609_0011),
    ] {
        let upload = Request::Upload { address: Address::new(index, subindex), is_complete };
        assert_eq!(ask(&mut mailbox(), O, upload), Err(AbortCode(code)), "0x{index:04X}:{subindex:02X}");
    }
}

/// The same writes one bit inside the limits.
#[test]
fn what_is_within_the_limits_is_taken() {
    let whole = |index, data| Request::Download {
        address: Address::new(index, 0),
        is_complete: true,
        size: Some(10),
        data,
    };
    // a gap of 40 bits, and 24 bits
    let mapping: &[u8] = &[2, 0, 40, 0, 0, 0, 0x18, 0, 0x02, 0x20];
    let mut device = mailbox();
    assert_eq!(ask(&mut device, P, whole(0x1600, mapping)), Ok(vec![]));
    assert_eq!(device.server.values.rx_pdo_1600.in_use(), [0x0000_0028, 0x2002_0018]);
    // 1 byte, 8 bytes, 4 bytes
    for (to, data) in [((0x1C12, 0), &[0][..]), ((0x1C12, 3), &[0x03, 0x16]), ((0x1C12, 0), &[3])] {
        assert_eq!(write(&mut device, to, data), Ok(()));
    }
    assert_eq!(device.server.values.sync_manager_2_pdo_assignment.in_use(), [0x1602, 0x1600, 0x1603]);
}
