//! Two mailboxes that are asked the same.

use devc_runtime::coe::{Envelope, Information, Mailbox, Request, Response, Service};
use devc_runtime::object::Address;
use devc_runtime::sdo::{
    CommunicationState, Dictionary, Names, PdoRules, Place, Range, Server, Slot, Values,
};

const LONGEST: usize = 2048;

/// The device twice: of generated values, and of values made while the program runs.
pub(crate) struct Pair<V, M = devc_virtual::drive::Values> {
    generated: Mailbox<V, (), LONGEST>,
    pub(crate) made: Mailbox<M, (), LONGEST>,
    pub(crate) state: CommunicationState,
    /// How many answers were compared.
    pub(crate) answers: usize,
    size: usize,
    counter: u8,
}

fn mailbox<V: Values>(values: V, names: Option<&'static Names>) -> Mailbox<V, (), LONGEST> {
    let server = Server::new(values, ());
    match names {
        Some(names) => Mailbox::with_information(server, names),
        None => Mailbox::new(server),
    }
}

impl<V: Values, M: Values> Pair<V, M> {
    /// Mailboxes of so many bytes.
    pub(crate) fn new(
        generated: V,
        made: M,
        names: Option<(&'static Names, &'static Names)>,
        size: usize,
    ) -> Self {
        let (generated, made) =
            (mailbox(generated, names.map(|it| it.0)), mailbox(made, names.map(|it| it.1)));
        Self { generated, made, state: CommunicationState::PreOperational, answers: 0, size, counter: 0 }
    }

    fn envelope(&mut self, service: Service) -> Envelope {
        self.counter = self.counter % 7 + 1;
        Envelope { counter: self.counter, ..Envelope::new(service) }
    }

    /// Both answers, as they are in the mailbox.
    fn both(&mut self, message: &[u8]) -> (Vec<u8>, Vec<u8>) {
        let (mut one, mut other) = (vec![0xAA; self.size], vec![0xAA; self.size]);
        let length = self.generated.answer(message, self.state, &mut one);
        one.truncate(length);
        let length = self.made.answer(message, self.state, &mut other);
        other.truncate(length);
        (one, other)
    }

    fn ask(&mut self, message: &[u8]) -> Vec<u8> {
        let (one, other) = self.both(message);
        assert_eq!(one, other, "asked {message:02X?} in {:?}", self.state);
        self.answers += 1;
        one
    }

    /// Both answers to a request.
    pub(crate) fn answers_to(&mut self, request: Request<'_>) -> (Vec<u8>, Vec<u8>) {
        let (mut message, envelope) = (vec![0; self.size], self.envelope(Service::SDO_REQUEST));
        let length = request.encode(envelope, &mut message).expect("it fits");
        self.both(&message[..length])
    }

    fn request(&mut self, request: Request<'_>) -> Vec<u8> {
        let (mut message, envelope) = (vec![0; self.size], self.envelope(Service::SDO_REQUEST));
        let length = request.encode(envelope, &mut message).expect("it fits");
        self.ask(&message[..length])
    }

    /// Uploads to the end; the value, empty if it was refused.
    pub(crate) fn upload(&mut self, address: Address, is_complete: bool) -> Vec<u8> {
        let answer = self.request(Request::Upload { address, is_complete });
        let (_, body) = Envelope::open(&answer).expect("it is a message");
        let (size, mut value) = match Response::decode(body) {
            Ok(Response::Uploaded { size: Some(size), data, .. }) => (size as usize, data.to_vec()),
            _ => return Vec::new(),
        };
        let mut toggle = false;
        while value.len() < size {
            let answer = self.request(Request::UploadSegment { toggle });
            let (_, body) = Envelope::open(&answer).expect("it is a message");
            let Ok(Response::SegmentUploaded { data, .. }) = Response::decode(body) else { break };
            value.extend_from_slice(data);
            toggle = !toggle;
        }
        value
    }

    /// Downloads to the end, or as far as it is let.
    pub(crate) fn download(&mut self, address: Address, is_complete: bool, value: &[u8]) {
        let room = if (1..=4).contains(&value.len()) { 4 } else { self.size - 16 };
        let (data, mut rest) = value.split_at(value.len().min(room));
        let size = u32::try_from(value.len()).ok();
        self.request(Request::Download { address, is_complete, size, data });
        let mut toggle = false;
        while !rest.is_empty() {
            let (data, more) = rest.split_at(rest.len().min(self.size - 9));
            self.request(Request::DownloadSegment { toggle, is_last: more.is_empty(), data });
            (rest, toggle) = (more, !toggle);
        }
    }

    /// Asks about the dictionary.
    pub(crate) fn inform(&mut self, asked: Information<'_>) {
        let (mut message, envelope) = (vec![0; self.size], self.envelope(Service::SDO_INFORMATION));
        let length = asked.encode(envelope, &mut message).expect("it fits");
        self.ask(&message[..length]);
    }

    /// The next piece of a list.
    pub(crate) fn proceed(&mut self) -> usize {
        let (mut one, mut other) = (vec![0xAA; self.size], vec![0xAA; self.size]);
        let length = self.generated.proceed(&mut one);
        assert_eq!(length, self.made.proceed(&mut other));
        assert_eq!(one, other);
        length
    }
}

/// A device as it would be if it did complete access; none that is shipped says so.
#[derive(Clone, Copy)]
pub(crate) struct Whole<V>(pub(crate) V);

impl<V: Values> Values for Whole<V> {
    fn table(&self) -> &'static Dictionary {
        self.0.table()
    }

    fn ranges(&self) -> &'static [Range] {
        self.0.ranges()
    }

    fn has_complete_access(&self) -> bool {
        true
    }

    fn process_data(&self) -> Option<&'static PdoRules> {
        self.0.process_data()
    }

    fn slot(&mut self, place: Place) -> Option<Slot<'_>> {
        self.0.slot(place)
    }
}
