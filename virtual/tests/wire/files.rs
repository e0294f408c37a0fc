//! Files over the mailbox, where a virtual drive says that it takes none (ETG.1000.6, FoE: opcodes 1 read, 2 write, 3 data, 4
//! acknowledge, 5 error; errors 0x8001 not found, 0x8002 access denied, 0x8004 illegal).

use std::path::Path;

use devc::source::Memory;
use devc_virtual::Subdevice;
use devc_virtual::drive::{Drive, Model};

use crate::devices::Any;
use crate::master::*;
use crate::states::{manager, request};

const OUT: u16 = 0x1000;
const IN: u16 = 0x1100;

fn bench(protocols: &str) -> Bench {
    let text = include_str!("../shared/own.toml").replace(r#"["CoE", "FoE"]"#, protocols);
    let memory = Memory::default().with("own/device.toml", text.into_bytes());
    let family = devc::compile(&memory, Path::new("own")).family.expect("a description without errors");
    let drive: Any = Box::new(Drive::new(Model::new(&family.members[0])));
    let mut bench = Bench::new(vec![Subdevice::new(drive, Vec::new())]);
    bench.send(APWR, 0, 0x0010, &STATION.to_le_bytes());
    bench
}

fn in_bootstrap(protocols: &str) -> Bench {
    let mut bench = bench(protocols);
    manager(&mut bench, 0, (OUT, 256), 0x26);
    manager(&mut bench, 1, (IN, 256), 0x22);
    assert_eq!(request(&mut bench, 0x03), (0x03, 0), "{:?}", bench.told());
    bench
}

/// What comes back for a message of a protocol, without the mailbox header: protocol, counter, content; none if nothing does.
fn answer(bench: &mut Bench, protocol: u8, counter: u8, content: &[u8]) -> Option<(u8, u8, Vec<u8>)> {
    let mut message = [0; 256];
    message[..2].copy_from_slice(&(content.len() as u16).to_le_bytes());
    message[5] = counter << 4 | protocol;
    message[6..6 + content.len()].copy_from_slice(content);
    assert!(bench.write(OUT, &message));
    let answer: [u8; 256] = bench.read(IN)?;
    let length = usize::from(u16::from_le_bytes([answer[0], answer[1]]));
    Some((answer[5] & 0x0F, answer[5] >> 4, answer[6..6 + length].to_vec()))
}

fn foe(opcode: u8, rest: &[u8]) -> Vec<u8> {
    [&[opcode, 0, 0, 0, 0, 0], rest].concat()
}

fn code((protocol, _, content): (u8, u8, Vec<u8>)) -> (u8, u8, u32) {
    (protocol, content[0], u32::from_le_bytes(content[2..6].try_into().unwrap()))
}

#[test]
fn a_file_is_refused_in_the_words_of_its_protocol() {
    let mut bench = in_bootstrap(r#"["CoE", "FoE"]"#);
    let (protocol, counter, content) = answer(&mut bench, 4, 1, &foe(2, b"firmware.bin")).expect("an answer");
    assert_eq!((protocol, counter), (4, 1));
    assert_eq!(content[..6], [5, 0, 0x02, 0x80, 0, 0], "access denied");
    assert_eq!(content[6..], *b"a virtual drive takes no files");
    let told = bench.told().join("\n");
    assert!(told.contains("refuses a file: error 0x8002"), "{told}");
    assert_eq!(answer(&mut bench, 4, 1, &foe(2, b"firmware.bin")), None, "the same once more");
    assert_eq!(answer(&mut bench, 4, 2, &foe(1, b"log.txt")).map(code), Some((4, 5, 0x8001)));
    assert_eq!(answer(&mut bench, 4, 3, &foe(3, b"some data")).map(code), Some((4, 5, 0x8004)));
    assert_eq!(answer(&mut bench, 4, 4, &foe(5, b"an error")), None, "an error ends what there was");
}

/// ETG.1000.4, mailbox error reply: type 1, 2 for a protocol that is not supported, 6 for what is too short.
#[test]
fn a_protocol_that_is_not_spoken_is_a_mailbox_error() {
    const UNSUPPORTED: [u8; 4] = [1, 0, 2, 0];
    let error = |answer: Option<(u8, u8, Vec<u8>)>| answer.map(|(protocol, _, content)| (protocol, content));
    let mut bench = in_bootstrap(r#"["CoE", "FoE"]"#);
    // CoE is not there in Bootstrap; AoE, EoE, SoE and VoE are nowhere
    for (protocol, counter) in [(3, 1), (1, 2), (2, 3), (5, 4), (15, 5)] {
        let found = error(answer(&mut bench, protocol, counter, &[0; 10]));
        assert_eq!(found, Some((0, UNSUPPORTED.to_vec())), "{protocol}");
    }
    assert_eq!(error(answer(&mut bench, 4, 6, &[])), Some((0, vec![1, 0, 6, 0])), "no opcode");
    let mut bench = in_bootstrap(r#"["CoE", "EoE"]"#);
    assert_eq!(error(answer(&mut bench, 4, 1, &foe(2, b"x"))), Some((0, UNSUPPORTED.to_vec())));
}

#[test]
fn files_are_refused_in_pre_operational_too() {
    let mut bench = bench(r#"["FoE", "CoE"]"#);
    manager(&mut bench, 0, (OUT, 128), 0x26);
    manager(&mut bench, 1, (0x1080, 128), 0x22);
    assert_eq!(request(&mut bench, 0x02), (0x02, 0));
    let mut message = [0; 128];
    message[..13].copy_from_slice(&[7, 0, 0, 0, 0, 0x14, 2, 0, 0, 0, 0, 0, b'x']);
    assert!(bench.write(OUT, &message));
    let answer: [u8; 128] = bench.read(0x1080).expect("an answer");
    assert_eq!(answer[5..12], [0x14, 5, 0, 0x02, 0x80, 0, 0]);
    // CoE goes on, with the counter of both
    message[..12].copy_from_slice(&[10, 0, 0, 0, 0, 0x23, 0, 0x20, 0x40, 0x00, 0x10, 0]);
    assert!(bench.write(OUT, &message));
    let answer: [u8; 128] = bench.read(0x1080).expect("an answer");
    assert_eq!((answer[5], &answer[12..16]), (0x23, &0x0002_0192_u32.to_le_bytes()[..]));
}
