//! SDO transfers as a master carries them out, message by message (ETG.1000.6, SDO services).

use core::fmt;

use super::{Envelope, Malformed, Request, Response, Service};
use crate::bytes::copy;
use crate::object::Address;
use crate::sdo::AbortCode;

/// What an answer means for a transfer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Answered {
    /// There is a further request to be sent.
    More,
    /// The transfer is done.
    Done,
    /// The message is about something else, as an emergency: the answer is still to come.
    Other,
}

/// Why a transfer ends before it is done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Failure {
    /// The device refuses it.
    Aborted(AbortCode),
    /// The answer cannot be read.
    Malformed(Malformed),
    /// The answer is not one to the request: a master gives the transfer up by [`Request::Abort`].
    Unexpected,
    /// The value is longer than the buffer for it, or than the device said.
    TooLong,
}

impl From<Malformed> for Failure {
    fn from(malformed: Malformed) -> Self {
        Self::Malformed(malformed)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Aborted(code) => code.fmt(f),
            Self::Malformed(malformed) => malformed.fmt(f),
            Self::Unexpected => f.write_str("the answer is not one to the request"),
            Self::TooLong => f.write_str("the value is longer than expected"),
        }
    }
}

impl core::error::Error for Failure {}

/// A value that is read: [`Upload::request`] and [`Upload::take`] in turn, until that is [`Answered::Done`].
///
/// ```
/// use devc_runtime::coe::{Answered, Upload};
/// use devc_runtime::object::Address;
///
/// let mut buffer = [0; 8];
/// let mut upload = Upload::new(Address::new(0x6061, 0), &mut buffer);
/// let mut message = [0; 16];
/// assert_eq!(upload.request(1, &mut message), Ok(16));
/// // the mailbox is written and read, and this comes back: mode 8
/// let answer = [10, 0, 0, 0, 0, 0x13, 0, 0x30, 0x4F, 0x61, 0x60, 0, 8, 0, 0, 0];
/// assert_eq!(upload.take(&answer), Ok(Answered::Done));
/// assert_eq!(upload.value(), [8]);
/// ```
#[derive(Debug)]
pub struct Upload<'b> {
    address: Address,
    is_complete: bool,
    buffer: &'b mut [u8],
    /// The length of the value, once it is known, and how much of it is there.
    total: Option<usize>,
    done: usize,
    toggle: bool,
}

impl<'b> Upload<'b> {
    /// Of an entry.
    pub const fn new(address: Address, buffer: &'b mut [u8]) -> Self {
        Self { address, is_complete: false, buffer, total: None, done: 0, toggle: false }
    }

    /// Of a whole object, from an entry on.
    pub const fn whole(address: Address, buffer: &'b mut [u8]) -> Self {
        Self { is_complete: true, ..Self::new(address, buffer) }
    }

    /// Writes the next request, with the counter of the mailbox, and tells its length.
    pub fn request(&self, counter: u8, message: &mut [u8]) -> Result<usize, Malformed> {
        let request = match self.total {
            None => Request::Upload { address: self.address, is_complete: self.is_complete },
            Some(_) => Request::UploadSegment { toggle: self.toggle },
        };
        request.encode(envelope(counter), message)
    }

    /// Takes a message of the device.
    pub fn take(&mut self, message: &[u8]) -> Result<Answered, Failure> {
        let Some(response) = response(message)? else { return Ok(Answered::Other) };
        match (response, self.total) {
            (Response::Abort { code, .. }, _) => Err(Failure::Aborted(code)),
            (Response::Uploaded { address, is_complete, size, data }, None)
                if (address, is_complete) == (self.address, self.is_complete) =>
            {
                let size = size.map_or(Ok(data.len()), usize::try_from).map_err(|_| Failure::TooLong)?;
                self.total = Some(size);
                self.keep(data)?;
                Ok(if self.done < size { Answered::More } else { Answered::Done })
            }
            (Response::SegmentUploaded { toggle, is_last, data }, Some(total)) if toggle == self.toggle => {
                self.keep(data)?;
                self.toggle = !toggle;
                match (is_last, self.done < total) {
                    (true, false) => Ok(Answered::Done),
                    (false, true) => Ok(Answered::More),
                    _ => Err(Failure::Unexpected),
                }
            }
            _ => Err(Failure::Unexpected),
        }
    }

    /// What has come of the value.
    pub fn value(&self) -> &[u8] {
        self.buffer.get(..self.done).unwrap_or_default()
    }

    fn keep(&mut self, data: &[u8]) -> Result<(), Failure> {
        let end = self.done.saturating_add(data.len());
        if end > self.buffer.len() || self.total.is_some_and(|total| end > total) {
            return Err(Failure::TooLong);
        }
        let copied = copy(self.buffer.get_mut(self.done..).unwrap_or_default(), data);
        self.done = self.done.saturating_add(copied);
        Ok(())
    }
}

/// A value that is written: [`Download::request`] and [`Download::take`] in turn, until that is [`Answered::Done`].
#[derive(Debug, Clone, Copy)]
pub struct Download<'d> {
    address: Address,
    is_complete: bool,
    data: &'d [u8],
    /// How much of it is written, none before the first answer; and how much is on its way.
    done: Option<usize>,
    sent: usize,
    toggle: bool,
}

impl<'d> Download<'d> {
    /// To an entry.
    pub const fn new(address: Address, data: &'d [u8]) -> Self {
        Self { address, is_complete: false, data, done: None, sent: 0, toggle: false }
    }

    /// To a whole object, from an entry on.
    pub const fn whole(address: Address, data: &'d [u8]) -> Self {
        Self { is_complete: true, ..Self::new(address, data) }
    }

    /// Writes the next request into a message that is as long as the mailbox, with its counter, and tells its length.
    pub fn request(&mut self, counter: u8, message: &mut [u8]) -> Result<usize, Malformed> {
        let rest = self.data.get(self.done.unwrap_or(0)..).unwrap_or_default();
        let Self { address, is_complete, toggle, .. } = *self;
        let (request, sent) = match self.done {
            None => {
                let room = message.len().saturating_sub(HEAD);
                // up to four bytes have a place in the head
                let first = if rest.len() <= 4 { rest } else { rest.get(..room).unwrap_or(rest) };
                let size = u32::try_from(self.data.len()).map_err(|_| Malformed::WrongLength)?;
                (Request::Download { address, is_complete, size: Some(size), data: first }, first.len())
            }
            Some(_) => {
                let part = rest.get(..message.len().saturating_sub(SEGMENT_HEAD)).unwrap_or(rest);
                let is_last = part.len() == rest.len();
                (Request::DownloadSegment { toggle, is_last, data: part }, part.len())
            }
        };
        self.sent = sent;
        request.encode(envelope(counter), message)
    }

    /// Takes a message of the device.
    pub fn take(&mut self, message: &[u8]) -> Result<Answered, Failure> {
        let Some(response) = response(message)? else { return Ok(Answered::Other) };
        match (response, self.done) {
            (Response::Abort { code, .. }, _) => return Err(Failure::Aborted(code)),
            (Response::Downloaded { address, is_complete }, None)
                if (address, is_complete) == (self.address, self.is_complete) => {}
            (Response::SegmentDownloaded { toggle }, Some(_)) if toggle == self.toggle => {
                self.toggle = !toggle;
            }
            _ => return Err(Failure::Unexpected),
        }
        let done = self.done.unwrap_or(0).saturating_add(self.sent);
        self.done = Some(done);
        Ok(if done < self.data.len() { Answered::More } else { Answered::Done })
    }
}

/// Bytes in front of the data of a download in its own message, and of a segment.
const HEAD: usize = 16;
const SEGMENT_HEAD: usize = 9;

fn envelope(counter: u8) -> Envelope {
    Envelope { counter, ..Envelope::new(Service::SDO_REQUEST) }
}

/// The answer in a message; none if it is about something else. An abort comes as a request.
fn response(message: &[u8]) -> Result<Option<Response<'_>>, Failure> {
    let (envelope, body) = Envelope::open(message)?;
    match envelope.service {
        Service::SDO_RESPONSE | Service::SDO_REQUEST => Ok(Some(Response::decode(body)?)),
        _ => Ok(None),
    }
}
