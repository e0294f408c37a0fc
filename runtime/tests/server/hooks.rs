//! What a firmware does at a transfer.

use devc_runtime::object::{Address, Value};
use devc_runtime::sdo::CommunicationState::{Operational, PreOperational};
use devc_runtime::sdo::{AbortCode, Hooks, Part, Server};

use crate::device::{GAIN, LIST, MIXED, NOTE, SECRET, Tiny};

/// Counts what is asked, computes one value, refuses another, and acts on a third.
#[derive(Default)]
struct Firmware {
    asked: Vec<Address>,
    opened: u32,
}

impl Hooks<Tiny> for Firmware {
    fn before_upload(&mut self, values: &mut Tiny, address: Address) -> Result<(), AbortCode> {
        self.asked.push(address);
        match address {
            GAIN => values.gain += 1,
            NOTE => return Err(AbortCode::HARDWARE_ERROR),
            _ => {}
        }
        Ok(())
    }

    fn before_download(&mut self, values: &mut Tiny, address: Address, data: &[u8]) -> Result<(), AbortCode> {
        let is_below = address == GAIN && i16::from_slice(data)? < values.gain;
        if is_below { Err(AbortCode::MAXIMUM_BELOW_MINIMUM) } else { Ok(()) }
    }

    fn after_download(&mut self, values: &mut Tiny, address: Address) {
        if address == SECRET && values.secret == 42 {
            self.opened += 1;
            values.secret = 0;
        }
    }
}

fn server() -> Server<Tiny, Firmware> {
    Server::new(Tiny::NEW, Firmware::default())
}

#[test]
fn a_value_is_computed_when_it_is_asked_for() {
    let mut server = server();
    for expected in [6, 7] {
        assert_eq!(server.upload(GAIN, Operational, &mut [0; 2]), Ok([expected, 0].as_slice()));
    }
    assert_eq!(server.hooks.asked, [GAIN, GAIN]);
}

#[test]
fn a_refusal_is_told_and_changes_nothing() {
    let mut server = server();
    assert_eq!(server.upload(NOTE, Operational, &mut [0; 8]), Err(AbortCode::HARDWARE_ERROR));
    let refused = Err(AbortCode::MAXIMUM_BELOW_MINIMUM);
    assert_eq!(server.download(GAIN, PreOperational, &[4, 0]), refused);
    assert_eq!(server.values, Tiny::NEW);
    assert_eq!(server.download(GAIN, PreOperational, &[6, 0]), Ok(()));
    assert_eq!(server.values.gain, 6);
}

#[test]
fn a_written_value_sets_something_off() {
    let mut server = server();
    assert_eq!(server.download(SECRET, Operational, &[41, 0, 0, 0]), Ok(()));
    assert_eq!((server.hooks.opened, server.values.secret), (0, 41));
    assert_eq!(server.download(SECRET, Operational, &[42, 0, 0, 0]), Ok(()));
    assert_eq!((server.hooks.opened, server.values.secret), (1, 0));
}

#[test]
fn nothing_happens_where_the_table_refuses() {
    let mut server = server();
    assert_eq!(server.upload(SECRET, Operational, &mut [0; 4]), Err(AbortCode::WRITE_ONLY));
    let missing = Address::new(MIXED, 3);
    assert_eq!(server.upload(missing, Operational, &mut [0; 4]), Err(AbortCode::NO_SUCH_SUBINDEX));
    assert_eq!(server.download(SECRET, Operational, &[42, 0]), Err(AbortCode::LENGTH_TOO_LOW));
    assert_eq!((server.hooks.asked.len(), server.hooks.opened), (0, 0));
}

/// Of an object as a whole, the firmware is asked for what is going to be read: the entries that there are, up to the number that
/// subindex 0 has now, and none that cannot be read. Those were asked for when the transfer began.
#[test]
fn all_that_is_read_at_once_is_asked_for_once() {
    let read = |from: Address, skip: usize| {
        let (mut server, mut buffer) = (server(), [0; 32]);
        let told = server.upload_complete(from, PreOperational, &mut Part::new(&mut buffer, skip));
        assert_eq!(told, Ok(()), "{from}");
        server.hooks.asked.iter().map(|address| address.subindex).collect::<Vec<_>>()
    };
    assert_eq!(read(Address::new(LIST, 0), 0), [0, 1, 2]);
    assert_eq!(read(Address::new(LIST, 1), 0), [1, 2]);
    assert_eq!(read(Address::new(LIST, 0), 4), []);
    assert_eq!(read(Address::new(MIXED, 0), 0), [0, 1, 2], "3 is not there, 4 is only written");
    let refused = server().upload_complete(GAIN, PreOperational, &mut Part::new(&mut [0; 8], 0));
    assert_eq!(refused, Err(AbortCode::UNSUPPORTED_ACCESS));
}
