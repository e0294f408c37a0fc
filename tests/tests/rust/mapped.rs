//! Process data that a master makes itself, through the mailbox: what a device takes, and what it carries then.

#![allow(unreachable_pub)] // what derives `Device` has to be public

use devc_generated::s700::s700;
use devc_runtime::Device;
use devc_runtime::coe::{Envelope, Mailbox, Request, Response, Service};
use devc_runtime::object::Address;
use devc_runtime::pdo::{Mapping, Rx, Tx};
use devc_runtime::sdo::CommunicationState::{self, PreOperational};
use devc_runtime::sdo::{AbortCode, Access, Server, Values};

pub use mapped::dictionary::Dictionary;

#[derive(Debug, Device)]
#[device(path = "tests/rust/mapped")]
pub struct Mapped;

/// Sends a message, and reads what the device makes of it.
pub(crate) fn ask<V: Values>(
    mailbox: &mut Mailbox<V, (), 64>,
    state: CommunicationState,
    request: Request<'_>,
) -> Result<Vec<u8>, AbortCode> {
    let (mut message, mut answer) = ([0; 128], [0; 128]);
    let envelope = Envelope::new(Service::SDO_REQUEST);
    let length = request.encode(envelope, &mut message).expect("it fits");
    let length = mailbox.answer(&message[..length], state, &mut answer);
    let (_, body) = Envelope::open(&answer[..length]).expect("it is an answer");
    match Response::decode(body).expect("it is an answer") {
        Response::Abort { code, .. } => Err(code),
        Response::Uploaded { data, .. } => Ok(data.to_vec()),
        _ => Ok(Vec::new()),
    }
}

pub(crate) fn write<V: Values>(
    mailbox: &mut Mailbox<V, (), 64>,
    to: (u16, u8),
    data: &[u8],
) -> Result<(), AbortCode> {
    ask(mailbox, PreOperational, download(to, data)).map(|_| ())
}

pub(crate) fn download(to: (u16, u8), data: &[u8]) -> Request<'_> {
    let size = Some(data.len().try_into().expect("it is short"));
    Request::Download { address: Address::new(to.0, to.1), is_complete: false, size, data }
}

pub(crate) fn mailbox() -> Mailbox<Dictionary, (), 64> {
    Mailbox::new(Server::new(Dictionary::DEFAULT, ()))
}

/// Maps these words as ETG.1020 has a master do it.
fn map<V: Values>(mailbox: &mut Mailbox<V, (), 64>, pdo: u16, words: &[u32]) -> Result<(), AbortCode> {
    write(mailbox, (pdo, 0), &[0])?;
    for (subindex, word) in (1..).zip(words) {
        write(mailbox, (pdo, subindex), &word.to_le_bytes())?;
    }
    write(mailbox, (pdo, 0), &[words.len().try_into().expect("it is short")])
}

fn assign<V: Values>(mailbox: &mut Mailbox<V, (), 64>, to: u16, pdos: &[u16]) -> Result<(), AbortCode> {
    write(mailbox, (to, 0), &[0])?;
    for (subindex, pdo) in (1..).zip(pdos) {
        write(mailbox, (to, subindex), &pdo.to_le_bytes())?;
    }
    write(mailbox, (to, 0), &[pdos.len().try_into().expect("it is short")])
}

/// Numbers of so many bits one behind the other, the lowest bit of the first in the lowest of the first byte.
fn concatenated(parts: &[(u64, usize)]) -> Vec<u8> {
    let bits: Vec<bool> =
        parts.iter().flat_map(|(value, width)| (0..*width).map(move |bit| value >> bit & 1 == 1)).collect();
    bits.chunks(8).map(|byte| byte.iter().rev().fold(0, |high, bit| high << 1 | u8::from(*bit))).collect()
}

/// Every entry that is mappable this way, with its width as the table has it.
fn mappable(values: &impl Values, right: Access) -> Vec<Mapping> {
    let entries = values.table().objects().flat_map(|(index, object)| {
        object.entries.iter().filter(|entry| entry.access.includes(Access(right.0))).map(move |entry| {
            Mapping {
                address: Address::new(index, entry.subindex),
                bits: entry.bits.try_into().expect("it is short"),
            }
        })
    });
    entries.collect()
}

#[test]
fn whatever_can_be_mapped_is_taken_by_a_free_mapping() {
    let mut mailbox = Mailbox::new(Server::new(s700::dictionary::Dictionary::DEFAULT, ()));
    for (pdo, right) in [(0x1600, Access::RX_PDO), (0x1A00, Access::TX_PDO)] {
        let all = mappable(&s700::dictionary::Dictionary::DEFAULT, right);
        assert!(all.len() > 20, "{} in 0x{pdo:X}", all.len());
        for mapping in &all {
            assert_eq!(map(&mut mailbox, pdo, &[mapping.word()]), Ok(()), "{mapping:?}");
        }
        // as many as fit 64 bytes
        let mut bits = 0;
        let fit = all.iter().take_while(|mapping| {
            bits += usize::from(mapping.bits);
            bits <= 8 * 64
        });
        let words: Vec<u32> = fit.map(|mapping| mapping.word()).collect();
        assert_eq!(map(&mut mailbox, pdo, &words), Ok(()));
    }
}

#[test]
fn outputs_are_taken_as_they_are_mapped() {
    let mut mailbox = mailbox();
    // Ready, a gap of 2, Level, Torque, Word: 62 bits of the 64 that the PDO takes
    let words = [0x2000_0001, 0x0000_0002, 0x2001_0003, 0x2002_0018, 0x2005_0020];
    assert_eq!(map(&mut mailbox, 0x1600, &words), Ok(()));
    assert_eq!(assign(&mut mailbox, 0x1C12, &[0x1603, 0x1600, 0x1602]), Ok(()));
    let server = &mut mailbox.server;
    // 0x1603: 5 bits of an object that is in no dictionary, Torque, a gap of 3; 0x1602: Ready, a gap of 4, Level
    let torque = 0x00FF_FFFE; // -2
    let parts = [
        (0b10101, 5),
        (0x12_3456, 24),
        (0b111, 3),
        (1, 1),
        (0b11, 2),
        (0b110, 3),
        (torque, 24),
        (u64::from(u32::from_le_bytes(*b"wxyz")), 32),
        (0, 1),
        (0b1111, 4),
        (0b011, 3),
    ];
    let image = concatenated(&parts);
    assert_eq!(server.image_len::<Rx>(), image.len());
    assert_eq!(server.unpack_outputs(&image), Ok(()));
    let values = &server.values;
    // what is mapped twice is what came last
    assert_eq!((values.ready, values.level.get(), values.torque.get()), (false, 0b011, -2));
    assert_eq!(&values.word, b"wxyz");
    let offsets: Vec<usize> = server.mapped::<Rx>().map(|mapped| mapped.offset).collect();
    assert_eq!(offsets, [0, 5, 29, 32, 33, 35, 38, 62, 94, 95, 99]);
    let unknown =
        server.mapped::<Rx>().find(|mapped| mapped.mapping.address.index == 0x3000).expect("it is mapped");
    assert_eq!((unknown.pdo, unknown.offset, unknown.mapping.bits), (0x1603, 0, 5));
    for wrong in [image.len() - 1, image.len() + 1] {
        assert!(server.unpack_outputs(&vec![0; wrong]).is_err(), "{wrong} bytes");
    }
}

#[test]
fn inputs_are_made_as_they_are_mapped() {
    let mut mailbox = mailbox();
    let words = [0x2001_0003, 0x0000_0003, 0x2000_0001, 0x2004_0020, 0x2005_0020, 0x2009_0020];
    assert_eq!(map(&mut mailbox, 0x1A00, &words), Ok(()));
    assert_eq!(assign(&mut mailbox, 0x1C13, &[0x1A01, 0x1A00]), Ok(()));
    let server = &mut mailbox.server;
    server.values.ratio = 1.5;
    server.values.ready = true;
    assert_eq!(server.download(Address::new(0x2001, 0), PreOperational, &[5]), Ok(()));
    let mut image = vec![0xFF; server.image_len::<Tx>()];
    assert_eq!(server.pack_inputs(&mut image), Ok(()));
    let parts = [
        (5, 3),
        (0, 5),
        (0xFF_FFFB, 24),
        (5, 3),
        (0, 3),
        (1, 1),
        (0xFFFF_FFFE, 32),
        (u64::from(u32::from_le_bytes(*b"abc\0")), 32),
        (u64::from(1.5_f32.to_bits()), 32),
    ];
    let expected = concatenated(&parts);
    // behind the last entry a bit is left, which nobody maps
    let (last, whole) = expected.split_last().expect("there is some");
    assert_eq!((&image[..whole.len()], image[whole.len()] & 0x7F), (whole, *last));
}

/// Every selection of what the S700 can send, cut off where its 64 bytes end, against what SDOs read.
#[test]
fn what_is_sent_is_what_is_read() {
    type Dictionary = s700::dictionary::Dictionary;
    let all = mappable(&Dictionary::DEFAULT, Access::TX_PDO);
    for first in 0..all.len() {
        let mut mailbox = Mailbox::new(Server::new(Dictionary::DEFAULT, ()));
        let mut bits = 0;
        let chosen = all.iter().cycle().skip(first).step_by(3).take(30).take_while(|mapping| {
            bits += usize::from(mapping.bits);
            bits <= 8 * 64
        });
        let chosen: Vec<Mapping> = chosen.copied().collect();
        let words: Vec<u32> = chosen.iter().map(|mapping| mapping.word()).collect();
        assert_eq!(assign(&mut mailbox, 0x1C13, &[]), Ok(()));
        assert_eq!(map(&mut mailbox, 0x1A00, &words), Ok(()));
        assert_eq!(assign(&mut mailbox, 0x1C13, &[0x1A00]), Ok(()));
        let parts: Vec<(u64, usize)> = chosen
            .iter()
            .map(|mapping| {
                let upload = Request::Upload { address: mapping.address, is_complete: false };
                let data = ask(&mut mailbox, PreOperational, upload).expect("it can be read");
                let number = data.iter().rev().fold(0, |high, byte| high << 8 | u64::from(*byte));
                (number, mapping.bits.into())
            })
            .collect();
        let mut image = vec![0; mailbox.server.image_len::<Tx>()];
        assert_eq!(mailbox.server.pack_inputs(&mut image), Ok(()));
        assert_eq!(image, concatenated(&parts));
    }
}

/// Other values: on the way to Pre-Operational in front of all else, the rest behind it, each as its type has it.
#[test]
fn a_configuration_writes_other_values() {
    let list = mapped::configurations::PREPARED;
    let bare = |write: &devc_runtime::start_up::Write| {
        (write.transition, write.address.index, write.address.subindex, write.data().to_vec())
    };
    let expected = [
        ("IP", 0x2006, 0, vec![1, 0, 0, 0]),
        ("PS", 0x1C12, 0, vec![0]),
        ("PS", 0x1C12, 1, vec![0x02, 0x16]),
        ("PS", 0x1C12, 0, vec![1]),
        ("PS", 0x200A, 0, vec![0x34, 0x12]),
        ("SO", 0x2005, 0, b"no".to_vec()),
    ];
    assert_eq!(list.each_ref().map(bare), expected);
    let mut mailbox = mailbox();
    for it in list {
        let written = write(&mut mailbox, (it.address.index, it.address.subindex), it.data());
        assert_eq!(written, Ok(()), "{it}");
    }
}
