//! Messages of a master to the mailbox of a device: well-formed and not, with values, mappings and states of all kinds.

use bolero::TypeGenerator;
use devc_generated::{c887, pmc_sc6, s700};
use devc_runtime::coe::{Envelope, Information, Mailbox, Request, Response, Service};
use devc_runtime::object::Address;
use devc_runtime::pdo::{Rx, Tx};
use devc_runtime::sdo::{AbortCode, CommunicationState, Names, Range, Server, Values};

use crate::run::holds;

/// What a master does with a device.
#[derive(Debug, TypeGenerator)]
struct Input {
    device: u8,
    /// Bytes of the mailbox beyond the fewest.
    size: u8,
    steps: Vec<Step>,
}

#[derive(Debug, TypeGenerator)]
enum Step {
    State(u8),
    Bytes(Vec<u8>),
    Body { counter: u8, service: u8, body: Vec<u8> },
    Upload { entry: Entry, is_complete: bool },
    UploadSegment { toggle: bool },
    Download { entry: Entry, is_complete: bool, size: Option<u16>, data: Vec<u8> },
    DownloadSegment { toggle: bool, is_last: bool, data: Vec<u8> },
    Abort { entry: Entry },
    Write { entry: Entry, data: [u8; 8] },
    Map { pdo: u8, entries: Vec<Entry>, is_whole: bool },
    Assign { is_input: bool, pdos: Vec<u8> },
    Tell { kind: u8, of: u16 },
    Proceed,
    Restart,
    Outputs { byte: u8 },
}

/// An entry of the dictionary by its number, or any address.
#[derive(Debug, TypeGenerator)]
enum Entry {
    Known(u16),
    Any(u16, u8),
}

/// Bytes of the longest value that is taken in segments.
const BUFFER: usize = 64;

#[test]
fn messages() {
    holds("messages", 300, |input: &Input| {
        let size = 16 + usize::from(input.size);
        match input.device % 3 {
            0 => play(
                c887::dictionary::Dictionary::DEFAULT,
                Some(&c887::dictionary::NAMES),
                size,
                &input.steps,
            ),
            1 => play(s700::s700::dictionary::Dictionary::DEFAULT, None, size, &input.steps),
            _ => {
                let names = Some(&pmc_sc6::double::dictionary::NAMES);
                play(pmc_sc6::double::dictionary::Dictionary::DEFAULT, names, size, &input.steps);
            }
        }
    });
}

fn play<V: Values + Copy + PartialEq>(values: V, names: Option<&'static Names>, size: usize, steps: &[Step]) {
    let server = Server::new(values, ());
    let mailbox = names.map_or(Mailbox::new(server), |names| Mailbox::with_information(server, names));
    let objects = values.table().objects();
    let entries = objects.flat_map(|(index, object)| {
        object.entries.iter().map(move |entry| Address::new(index, entry.subindex))
    });
    let entries: Vec<Address> = entries.collect();
    let state = CommunicationState::PreOperational;
    let mut device = Device { mailbox, entries, size, state, by_outputs: false };
    for step in steps {
        device.take(step);
        device.maps_what_it_says();
    }
    device.keeps_limits();
}

/// A device with its mailbox.
struct Device<V> {
    mailbox: Mailbox<V, (), BUFFER>,
    entries: Vec<Address>,
    size: usize,
    state: CommunicationState,
    /// Whether values came with outputs, which nobody holds to limits.
    by_outputs: bool,
}

/// What came of a message.
#[derive(Debug, PartialEq)]
enum Answer {
    Nothing,
    Taken,
    Refused(AbortCode),
    Other,
}

impl<V: Values + Copy + PartialEq> Device<V> {
    fn address(&self, entry: &Entry) -> Address {
        match *entry {
            Entry::Known(number) => self.entries[usize::from(number) % self.entries.len()],
            Entry::Any(index, subindex) => Address::new(index, subindex),
        }
    }

    fn take(&mut self, step: &Step) {
        match step {
            Step::State(state) => {
                self.state = match state % 3 {
                    0 => CommunicationState::PreOperational,
                    1 => CommunicationState::SafeOperational,
                    _ => CommunicationState::Operational,
                };
            }
            Step::Bytes(bytes) => _ = self.send(bytes),
            Step::Body { counter, service, body } => {
                let length = u16::try_from(body.len() + 2).expect("it is short").to_le_bytes();
                let head = [length[0], length[1], 0, 0, 0, counter << 4 | 3, 0, service << 4];
                self.send(&[&head[..], body].concat());
            }
            Step::Upload { entry, is_complete } => {
                self.ask(Request::Upload { address: self.address(entry), is_complete: *is_complete });
            }
            Step::UploadSegment { toggle } => _ = self.ask(Request::UploadSegment { toggle: *toggle }),
            Step::Download { entry, is_complete, size, data } => {
                let (address, size) = (self.address(entry), size.map(u32::from));
                self.ask(Request::Download { address, is_complete: *is_complete, size, data });
            }
            Step::DownloadSegment { toggle, is_last, data } => {
                self.ask(Request::DownloadSegment { toggle: *toggle, is_last: *is_last, data });
            }
            Step::Abort { entry } => {
                self.ask(Request::Abort { address: self.address(entry), code: AbortCode::TIMEOUT });
            }
            Step::Write { entry, data } => self.write(self.address(entry), data),
            Step::Map { pdo, entries, is_whole } => self.map(*pdo, entries, *is_whole),
            Step::Assign { is_input, pdos } => self.assign(*is_input, pdos),
            Step::Tell { kind, of } => {
                let body = [kind % 8, 0, 0, 0, *of as u8, (of >> 8) as u8, kind >> 3, 0xFF];
                self.send(&[&[10, 0, 0, 0, 0, 3, 0, 0x80], &body[..]].concat());
            }
            Step::Proceed => {
                let mut answer = vec![0; self.size];
                let length = self.mailbox.proceed(&mut answer);
                self.is_sound(&answer[..length]);
            }
            Step::Restart => self.mailbox.restart(),
            Step::Outputs { byte } => {
                let length = self.mailbox.server.image_len::<Rx>();
                self.mailbox.server.unpack_outputs(&vec![*byte; length]).expect("it is as long as it says");
                self.by_outputs = true;
            }
        }
    }

    /// Sends a message. Only what is answered as written has changed a value.
    fn send(&mut self, message: &[u8]) -> Answer {
        let before = self.mailbox.server.values;
        let mut answer = vec![0xAA; self.size];
        let length = self.mailbox.answer(message, self.state, &mut answer);
        assert!(answer[length..].iter().all(|byte| *byte == 0xAA), "more was written than is told");
        let found = self.is_sound(&answer[..length]);
        let after = self.mailbox.server.values;
        // with a number that is none among them, values are not even the same as themselves
        let are_same = |one: V, other: V| one == other;
        assert!(
            found == Answer::Taken || are_same(before, after) || !are_same(before, before),
            "{found:?} of {message:02X?}"
        );
        found
    }

    /// Reads an answer, which has to be one.
    fn is_sound(&self, answer: &[u8]) -> Answer {
        if answer.is_empty() {
            return Answer::Nothing;
        }
        // a complaint about a message that is none
        if answer[5] & 0x0F == 0 {
            assert_eq!((answer.len(), &answer[..2]), (10, &[4, 0][..]), "{answer:02X?}");
            return Answer::Other;
        }
        let (envelope, body) = Envelope::open(answer).expect("an answer has an envelope");
        assert_eq!(body.len() + Envelope::SIZE, answer.len(), "{answer:02X?}");
        if envelope.service == Service::SDO_INFORMATION {
            Information::decode(body).expect("an answer is information");
            return Answer::Other;
        }
        match Response::decode(body).expect("an answer is a response") {
            Response::Downloaded { .. } | Response::SegmentDownloaded { .. } => Answer::Taken,
            Response::Abort { code, .. } => Answer::Refused(code),
            Response::Uploaded { .. } | Response::SegmentUploaded { .. } => Answer::Other,
        }
    }

    fn ask(&mut self, request: Request<'_>) -> Answer {
        let mut message = [0; 128];
        match request.encode(Envelope::new(Service::SDO_REQUEST), &mut message) {
            Ok(length) => self.send(&message[..length]),
            Err(_) => Answer::Nothing,
        }
    }

    /// Writes a value as long as its entry. What was taken is read again.
    fn write(&mut self, address: Address, data: &[u8; 8]) {
        let Ok(found) = self.mailbox.server.values.table().find(address) else { return };
        let length = usize::from(found.entry.bytes()).min(data.len());
        let (data, size) = (&data[..length], u32::try_from(length).ok());
        if self.ask(Request::Download { address, is_complete: false, size, data }) != Answer::Taken {
            return;
        }
        let (mut buffer, server) = ([0; 256], &mut self.mailbox.server);
        match server.upload(address, self.state, &mut buffer) {
            Ok(read) => {
                let rest = &data[read.len()..];
                assert!(
                    data.starts_with(read) && rest.iter().all(|byte| *byte == 0),
                    "{address}: {data:02X?}, {read:02X?}"
                );
            }
            Err(code) => assert_eq!(code, AbortCode::WRITE_ONLY, "{address}"),
        }
    }

    /// Maps entries to a PDO, as ETG.1020 has a master do it, with the width that they have.
    fn map(&mut self, pdo: u8, entries: &[Entry], is_whole: bool) {
        let index = if pdo & 1 == 0 { 0x1600 } else { 0x1A00 } + u16::from(pdo >> 1) % 8;
        let word = |entry| {
            let address = self.address(entry);
            let bits = self.mailbox.server.values.table().find(address).map_or(8, |found| found.entry.bits);
            u32::from(address.index) << 16 | u32::from(address.subindex) << 8 | u32::from(bits as u8)
        };
        let words: Vec<[u8; 4]> = entries.iter().map(|entry| word(entry).to_le_bytes()).collect();
        self.list(index, &words, is_whole);
    }

    fn assign(&mut self, is_input: bool, pdos: &[u8]) {
        let first = if is_input { 0x1A00 } else { 0x1600 };
        let pdos: Vec<[u8; 2]> =
            pdos.iter().map(|pdo| (first + u16::from(*pdo) % 16).to_le_bytes()).collect();
        self.list(if is_input { 0x1C13 } else { 0x1C12 }, &pdos, true);
    }

    /// Writes the elements of a list, with 0 in its count before, and their count behind.
    fn list<const N: usize>(&mut self, index: u16, elements: &[[u8; N]], is_whole: bool) {
        let mut write = |subindex, data: &[u8]| {
            let (address, size) = (Address::new(index, subindex), u32::try_from(data.len()).ok());
            self.ask(Request::Download { address, is_complete: false, size, data });
        };
        write(0, &[0]);
        for (subindex, element) in (1..=u8::MAX).zip(elements) {
            write(subindex, element);
        }
        if is_whole {
            write(0, &[elements.len() as u8]);
        }
    }

    /// Images are as long as what is mapped, and no other length is taken.
    fn maps_what_it_says(&mut self) {
        let mut server = Server::new(self.mailbox.server.values, ());
        let (outputs, inputs) = (server.image_len::<Rx>(), server.image_len::<Tx>());
        assert!(outputs <= 1486 && inputs <= 1486, "{outputs} and {inputs} bytes do not fit a frame");
        let mut image = vec![0; inputs + 1];
        assert!(server.pack_inputs(&mut image).is_err(), "too long an image");
        let first = server.pack_inputs(&mut image[..inputs]).map(|()| image.clone());
        assert_eq!(server.pack_inputs(&mut image[..inputs]).map(|()| image), first, "inputs change unread");
        assert!(first.is_ok() && server.unpack_outputs(&vec![0; outputs + 1]).is_err());
        assert!(server.unpack_outputs(&vec![0; outputs]).is_ok());
    }

    /// No value lies outside its limits, whatever was written.
    fn keeps_limits(&mut self) {
        if self.by_outputs {
            return;
        }
        let mut server = Server::new(self.mailbox.server.values, ());
        for address in &self.entries {
            let found = server.values.table().find(*address).expect("it is one of the table");
            let limits = found.place().and_then(|place| Range::of(server.values.ranges(), place));
            let mut buffer = [0; 256];
            if let (Some(limits), Ok(data)) = (limits, server.upload(*address, self.state, &mut buffer)) {
                assert_eq!(limits.check(data), Ok(()), "{address}: {data:02X?}");
            }
        }
    }
}
