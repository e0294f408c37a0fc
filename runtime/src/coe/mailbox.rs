//! The device's side of the mailbox: a message in, the answer out.

use super::envelope::{Envelope, MailboxError, Malformed, Service};
use super::request::{Request, entry};
use super::transfer::Transfer;
use super::{Emergency, Response};
use crate::object::Address;
use crate::sdo::{AbortCode, CommunicationState, Hooks, Names, Server, Values};

/// The mailbox of a device, which serves its dictionary.
///
/// What a master wrote into the mailbox goes through [`Mailbox::answer`]; what comes out is for the master to read.
/// Between two messages it keeps what is under way: a transfer in segments, and what is left of a list.
///
/// Values longer than the mailbox are uploaded in segments from where they are kept. To take a value in segments, or an
/// object as a whole, it has to be put together first: `BUFFER` is the longest in bytes, and 0 where everything that
/// can be written fits the mailbox.
#[derive(Debug, Clone)]
pub struct Mailbox<V, H = (), const BUFFER: usize = 0> {
    /// The dictionary.
    pub server: Server<V, H>,
    pub(super) names: Option<&'static Names>,
    pub(super) transfer: Transfer,
    pub(super) buffer: [u8; BUFFER],
    /// The counter of the last message out.
    counter: u8,
    /// The counter of the last message in; 0 before the first.
    taken: u8,
}

/// Why an SDO request is not answered as it would like: aborted at an entry, or beyond what a message can say.
pub(super) enum Refusal {
    Abort(Address, AbortCode),
    Message(Malformed),
}

impl From<Malformed> for Refusal {
    fn from(malformed: Malformed) -> Self {
        Self::Message(malformed)
    }
}

impl<V: Values, H: Hooks<V>, const BUFFER: usize> Mailbox<V, H, BUFFER> {
    /// A mailbox that serves values, and tells nothing of the dictionary itself.
    pub const fn new(server: Server<V, H>) -> Self {
        Self::of(server, None)
    }

    /// A mailbox that also tells what is in the dictionary, with these names.
    pub const fn with_information(server: Server<V, H>, names: &'static Names) -> Self {
        Self::of(server, Some(names))
    }

    const fn of(server: Server<V, H>, names: Option<&'static Names>) -> Self {
        Self { server, names, transfer: Transfer::None, buffer: [0; BUFFER], counter: 0, taken: 0 }
    }

    /// Forgets what is under way, and which messages came: to be called when the device leaves Init, where a master
    /// begins to count anew. Values stay as they are.
    pub fn restart(&mut self) {
        (self.transfer, self.counter, self.taken) = (Transfer::None, 0, 0);
    }

    /// Answers a message: writes the answer and tells its length, 0 if there is none. `answer` is the master's side of
    /// the mailbox, as long as its sync manager says, at least 16 bytes.
    ///
    /// A message with the counter of the one before it is the same once more, from a master that did not see that it
    /// had arrived (ETG.1000.4, mailbox header, counter). It is not carried out again, and has no answer of its own: the
    /// first has one. A message that is not counted is never taken for another. What was answered but got lost on its
    /// way is not repeated here but where the mailbox is, by the repeat bits of its sync manager.
    pub fn answer(&mut self, message: &[u8], state: CommunicationState, answer: &mut [u8]) -> usize {
        if self.is_repeated(message) {
            return 0;
        }
        let written = match Envelope::open(message) {
            Ok((asked, body)) => self.serve(asked, body, state, answer),
            Err(malformed) => Err(malformed),
        };
        written.unwrap_or_else(|malformed| {
            let counter = self.count();
            MailboxError::from(malformed).encode(counter, answer).unwrap_or(0)
        })
    }

    /// Takes a message of another protocol, which a firmware answers itself: the counter of its answer, or none if the message is
    /// the last one once more.
    pub fn accept(&mut self, message: &[u8]) -> Option<u8> {
        let is_counted = Envelope::counter(message) != 0;
        if self.is_repeated(message) {
            return None;
        }
        Some(if is_counted { self.count() } else { 0 })
    }

    /// Whether a message is the last one once more. All protocols of the mailbox are counted together.
    fn is_repeated(&mut self, message: &[u8]) -> bool {
        let counter = Envelope::counter(message);
        let is_repeated = counter != 0 && counter == self.taken;
        self.taken = counter;
        is_repeated
    }

    /// What an answer goes on with, once the master has read what came before: the next piece of a list. Its length is
    /// 0 if nothing is left.
    pub fn proceed(&mut self, answer: &mut [u8]) -> usize {
        if !matches!(self.transfer, Transfer::List { .. }) {
            return 0;
        }
        let envelope = Envelope { counter: self.count(), ..Envelope::new(Service::SDO_INFORMATION) };
        self.list_piece(envelope, answer).unwrap_or(0)
    }

    /// Writes an emergency message and tells its length.
    pub fn emergency(&mut self, emergency: &Emergency, answer: &mut [u8]) -> usize {
        let envelope = Envelope { counter: self.count(), ..Envelope::new(Service::EMERGENCY) };
        emergency.encode(envelope, answer).unwrap_or(0)
    }

    fn serve(
        &mut self,
        asked: Envelope,
        body: &[u8],
        state: CommunicationState,
        answer: &mut [u8],
    ) -> Result<usize, Malformed> {
        // a master that does not count gets answers that are not counted
        let counter = if asked.counter == 0 { 0 } else { self.count() };
        let envelope = Envelope { counter, number: 0, ..asked };
        match asked.service {
            Service::SDO_REQUEST => self.sdo(envelope, body, state, answer),
            Service::SDO_INFORMATION => self.information(envelope, body, answer),
            Service(other) => Err(Malformed::UnknownCommand(other)),
        }
    }

    fn sdo(
        &mut self,
        envelope: Envelope,
        body: &[u8],
        state: CommunicationState,
        answer: &mut [u8],
    ) -> Result<usize, Malformed> {
        let refusal = match Request::decode(body) {
            Ok(request) => match self.transfer(request, state, envelope, answer) {
                Ok(length) => return Ok(length),
                Err(refusal) => refusal,
            },
            Err(Malformed::UnknownCommand(_)) => {
                let rest = body.get(1..).unwrap_or_default();
                Refusal::Abort(entry(rest)?.0, AbortCode::UNKNOWN_COMMAND_SPECIFIER)
            }
            Err(malformed) => Refusal::Message(malformed),
        };
        self.transfer = Transfer::None;
        match refusal {
            Refusal::Abort(address, code) => Response::Abort { address, code }.encode(envelope, answer),
            Refusal::Message(malformed) => Err(malformed),
        }
    }

    /// The number of the next message: 1 to 7 in turn.
    fn count(&mut self) -> u8 {
        self.counter = if self.counter >= 7 { 1 } else { self.counter.saturating_add(1) };
        self.counter
    }
}
