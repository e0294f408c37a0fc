//! SDO transfers as a device carries them out, in one message or in segments.

use super::envelope::{Envelope, Malformed, Service};
use super::mailbox::{Mailbox, Refusal};
use super::request::{Request, complete_bit, place};
use super::segment::Segment;
use super::writer::Writer;
use super::{ListKind, Response};
use crate::bytes::copy;
use crate::object::Address;
use crate::sdo::{AbortCode, CommunicationState, Hooks, Part, Server, Values, found};

/// What is under way between two messages.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Transfer {
    None,
    /// A value that is uploaded: so many bytes are done.
    Upload {
        from: From,
        done: usize,
        toggle: bool,
    },
    /// A value that is downloaded: so many of its bytes are in the buffer.
    Download {
        from: From,
        size: usize,
        done: usize,
        toggle: bool,
    },
    /// A list: so many indices are told.
    List {
        kind: ListKind,
        done: usize,
    },
}

/// What is transferred.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct From {
    address: Address,
    is_complete: bool,
}

/// Bytes in front of the data of an upload in its own message, and of an upload in segments.
const HEAD: usize = 16;
const SEGMENT_HEAD: usize = 9;

impl<V: Values, H: Hooks<V>, const BUFFER: usize> Mailbox<V, H, BUFFER> {
    /// Carries out a request. Each that begins a transfer ends the one before it.
    pub(super) fn transfer(
        &mut self,
        request: Request<'_>,
        state: CommunicationState,
        envelope: Envelope,
        answer: &mut [u8],
    ) -> Result<usize, Refusal> {
        match request {
            Request::Upload { address, is_complete } => {
                let from = From { address, is_complete };
                self.upload(from, state, envelope, answer)
            }
            Request::UploadSegment { toggle } => self.upload_segment(toggle, state, envelope, answer),
            Request::Download { address, is_complete, size, data } => {
                let from = From { address, is_complete };
                self.download(from, size, data, state)?;
                Ok(Response::Downloaded { address, is_complete }.encode(envelope, answer)?)
            }
            Request::DownloadSegment { toggle, is_last, data } => {
                self.download_segment(Segment { toggle, is_last, data }, state)?;
                Ok(Response::SegmentDownloaded { toggle }.encode(envelope, answer)?)
            }
            Request::Abort { .. } => {
                self.transfer = Transfer::None;
                Ok(0)
            }
        }
    }

    fn upload(
        &mut self,
        from: From,
        state: CommunicationState,
        envelope: Envelope,
        answer: &mut [u8],
    ) -> Result<usize, Refusal> {
        let From { address, is_complete } = from;
        self.transfer = Transfer::None;
        let prepared = match is_complete {
            true => self.server.prepare_complete(address, state),
            false => self.server.prepare(address, state),
        };
        prepared.map_err(|code| Refusal::Abort(address, code))?;
        let mut four = [0; 4];
        let total = self.fill(from, state, &mut Part::new(&mut four, 0))?;
        let size = u32::try_from(total).map_err(|_| Refusal::Abort(address, AbortCode::OUT_OF_MEMORY))?;
        if let Some(data) = four.get(..total).filter(|data| !data.is_empty()) {
            let response = Response::Uploaded { address, is_complete, size: Some(size), data };
            return Ok(response.encode(envelope, answer)?);
        }
        let mut part = Part::new(answer.get_mut(HEAD..).ok_or(Malformed::NoRoom)?, 0);
        self.fill(from, state, &mut part)?;
        let done = part.filled();
        if done < total {
            self.transfer = Transfer::Upload { from, done, toggle: false };
        }
        let command = 0x41 | complete_bit(is_complete);
        let head = Writer::new(Envelope::body(answer)).put(&[command]).put(&place(address));
        let head = head.put(&size.to_le_bytes()).end()?;
        let envelope = Envelope { service: Service::SDO_RESPONSE, ..envelope };
        Ok(envelope.seal(answer, head.saturating_add(done))?)
    }

    fn upload_segment(
        &mut self,
        toggle: bool,
        state: CommunicationState,
        envelope: Envelope,
        answer: &mut [u8],
    ) -> Result<usize, Refusal> {
        let Transfer::Upload { from, done, toggle: expected } = self.transfer else { return Err(nothing()) };
        in_turn(from, toggle, expected)?;
        let head = Writer::new(Envelope::body(answer)).pad_to(HEAD.saturating_sub(Envelope::SIZE)).end()?;
        let mut part = Part::new(answer.get_mut(SEGMENT_HEAD..).unwrap_or_default(), done);
        self.fill(from, state, &mut part)?;
        let (filled, is_last) = (part.filled(), part.is_last());
        self.transfer = match is_last {
            true => Transfer::None,
            false => Transfer::Upload { from, done: done.saturating_add(filled), toggle: !expected },
        };
        let command = Segment::command(toggle, is_last, filled);
        Writer::new(Envelope::body(answer)).put(&[command]).end()?;
        let envelope = Envelope { service: Service::SDO_RESPONSE, ..envelope };
        Ok(envelope.seal(answer, head.max(filled.saturating_add(1)))?)
    }

    /// Reads a part of what is transferred, and tells the length of the whole.
    fn fill(&mut self, from: From, state: CommunicationState, part: &mut Part<'_>) -> Result<usize, Refusal> {
        let filled = match from.is_complete {
            true => self.server.fill_complete(from.address, state, part),
            false => self.server.fill(from.address, state, part),
        };
        filled.map_err(|code| Refusal::Abort(from.address, code))?;
        Ok(part.total())
    }

    /// Writes a value, or keeps the first part of it.
    fn download(
        &mut self,
        from: From,
        size: Option<u32>,
        data: &[u8],
        state: CommunicationState,
    ) -> Result<(), Refusal> {
        self.transfer = Transfer::None;
        let refuse = |code| Refusal::Abort(from.address, code);
        let Some(size) = size else {
            let bytes = found(&self.server.values, from.address).map_err(refuse)?.entry.bytes();
            return write(&mut self.server, from, data.get(..bytes.into()).unwrap_or(data), state);
        };
        let size = usize::try_from(size).map_err(|_| refuse(AbortCode::OUT_OF_MEMORY))?;
        if data.len() == size {
            return write(&mut self.server, from, data, state);
        }
        if !from.is_complete {
            self.server.expect_download(from.address, state, size).map_err(refuse)?;
        }
        if size > BUFFER {
            return Err(refuse(AbortCode::OUT_OF_MEMORY));
        }
        let done = self.keep(data, 0);
        self.transfer = Transfer::Download { from, size, done, toggle: false };
        Ok(())
    }

    fn download_segment(&mut self, segment: Segment<'_>, state: CommunicationState) -> Result<(), Refusal> {
        let Transfer::Download { from, size, done, toggle } = self.transfer else { return Err(nothing()) };
        in_turn(from, segment.toggle, toggle)?;
        let so_far = done.saturating_add(segment.data.len());
        if so_far > size {
            return Err(Refusal::Abort(from.address, AbortCode::LENGTH_TOO_HIGH));
        }
        let done = self.keep(segment.data, done);
        if !segment.is_last {
            self.transfer = Transfer::Download { from, size, done, toggle: !toggle };
            return Ok(());
        }
        self.transfer = Transfer::None;
        if done < size {
            return Err(Refusal::Abort(from.address, AbortCode::LENGTH_TOO_LOW));
        }
        write(&mut self.server, from, self.buffer.get(..size).unwrap_or_default(), state)
    }

    /// Puts a part into the buffer, and tells how much is there then.
    fn keep(&mut self, data: &[u8], done: usize) -> usize {
        let copied = copy(self.buffer.get_mut(done..).unwrap_or_default(), data);
        done.saturating_add(copied)
    }
}

fn write<V: Values, H: Hooks<V>>(
    server: &mut Server<V, H>,
    from: From,
    data: &[u8],
    state: CommunicationState,
) -> Result<(), Refusal> {
    let written = match from.is_complete {
        true => server.download_complete(from.address, state, data),
        false => server.download(from.address, state, data),
    };
    written.map_err(|code| Refusal::Abort(from.address, code))
}

/// A segment belongs to no transfer.
fn nothing() -> Refusal {
    Refusal::Abort(Address::new(0, 0), AbortCode::UNKNOWN_COMMAND_SPECIFIER)
}

fn in_turn(from: From, toggle: bool, expected: bool) -> Result<(), Refusal> {
    match toggle == expected {
        true => Ok(()),
        false => Err(Refusal::Abort(from.address, AbortCode::TOGGLE_BIT_NOT_ALTERNATED)),
    }
}
