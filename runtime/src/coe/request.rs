//! What a master asks of a dictionary.

use super::segment::{Segment, toggle, toggle_bit};
use super::writer::Writer;
use super::{Envelope, Malformed, Service};
use crate::object::Address;
use crate::sdo::AbortCode;

/// An SDO request (ETG.1000.6, SDO services).
///
/// ```
/// use devc_runtime::coe::{Envelope, Request, Service};
/// use devc_runtime::object::Address;
///
/// // the third of CSP's numbers, 8, into the modes of operation
/// let request = Request::Download {
///     address: Address::new(0x6060, 0),
///     is_complete: false,
///     size: Some(1),
///     data: &[8],
/// };
/// let mut frame = [0; 16];
/// assert_eq!(request.encode(Envelope::new(Service::SDO_REQUEST), &mut frame), Ok(16));
/// assert_eq!(frame[8..], [0x2F, 0x60, 0x60, 0, 8, 0, 0, 0]);
/// let (_, body) = Envelope::open(&frame).unwrap();
/// assert_eq!(Request::decode(body), Ok(request));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Request<'a> {
    /// Writes a value, or the first part of it.
    Download {
        /// The entry.
        address: Address,
        /// Whether the value is the whole object from the entry on.
        is_complete: bool,
        /// The bytes of the whole value; none if they are not told, and `data` has it in the first of its four.
        size: Option<u32>,
        /// The bytes of it that are here; the rest follows in segments.
        data: &'a [u8],
    },
    /// Writes a further part of a value.
    DownloadSegment {
        /// False for the first segment, then in turn.
        toggle: bool,
        /// Whether the value ends with it.
        is_last: bool,
        /// The bytes that are here.
        data: &'a [u8],
    },
    /// Reads a value.
    Upload {
        /// The entry.
        address: Address,
        /// Whether the whole object is meant, from the entry on.
        is_complete: bool,
    },
    /// Reads a further part of a value.
    UploadSegment {
        /// False for the first segment, then in turn.
        toggle: bool,
    },
    /// Gives up a transfer.
    Abort {
        /// The entry.
        address: Address,
        /// Why.
        code: AbortCode,
    },
}

impl<'a> Request<'a> {
    /// Reads what is in the envelope of an SDO request.
    pub fn decode(body: &'a [u8]) -> Result<Self, Malformed> {
        let (command, rest) = body.split_first().ok_or(Malformed::TooShort)?;
        match command >> 5 {
            0 => {
                let Segment { toggle, is_last, data } = Segment::decode(*command, rest)?;
                Ok(Self::DownloadSegment { toggle, is_last, data })
            }
            1 => {
                let Started { address, is_complete, size, data } = Started::decode(*command, rest)?;
                Ok(Self::Download { address, is_complete, size, data })
            }
            2 => {
                let (address, _) = entry(rest)?;
                Ok(Self::Upload { address, is_complete: is_complete(*command) })
            }
            3 => Ok(Self::UploadSegment { toggle: toggle(*command) }),
            4 => {
                let (address, code) = aborted(rest)?;
                Ok(Self::Abort { address, code })
            }
            _ => Err(Malformed::UnknownCommand(*command)),
        }
    }

    /// Writes the request, with this envelope around it, and tells the length of the message.
    pub fn encode(&self, envelope: Envelope, frame: &mut [u8]) -> Result<usize, Malformed> {
        let body = Envelope::body(frame);
        let length = match *self {
            Self::Download { address, is_complete, size, data } => {
                Started { address, is_complete, size, data }.encode(0x20, body)?
            }
            Self::DownloadSegment { toggle, is_last, data } => {
                Segment { toggle, is_last, data }.encode(body)?
            }
            Self::Upload { address, is_complete } => {
                short(0x40 | complete_bit(is_complete), address, [0; 4], body)?
            }
            Self::UploadSegment { toggle } => {
                Writer::new(body).put(&[0x60 | toggle_bit(toggle)]).pad_to(8).end()?
            }
            Self::Abort { address, code } => short(0x80, address, code.0.to_le_bytes(), body)?,
        };
        Envelope { service: Service::SDO_REQUEST, ..envelope }.seal(frame, length)
    }
}

/// A value, or the first part of it, as downloads carry it to a device and uploads from it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Started<'a> {
    pub(super) address: Address,
    pub(super) is_complete: bool,
    pub(super) size: Option<u32>,
    pub(super) data: &'a [u8],
}

impl<'a> Started<'a> {
    pub(super) fn decode(command: u8, rest: &'a [u8]) -> Result<Self, Malformed> {
        let (address, rest) = entry(rest)?;
        let (is_expedited, is_size_told) = (command & 0x02 != 0, command & 0x01 != 0);
        let (four, more) = rest.split_at_checked(4).ok_or(Malformed::TooShort)?;
        let is_complete = is_complete(command);
        if is_expedited {
            let used = 4_u8.saturating_sub(command >> 2 & 0x03);
            let size = is_size_told.then_some(used.into());
            let data = if is_size_told { four.get(..used.into()).unwrap_or(four) } else { four };
            return Ok(Self { address, is_complete, size, data });
        }
        let size = four.iter().rev().fold(0, |high, byte| high << 8 | u32::from(*byte));
        let expected = usize::try_from(size).unwrap_or(usize::MAX);
        Ok(Self { address, is_complete, size: Some(size), data: more.get(..expected).unwrap_or(more) })
    }

    /// Expedited where the value fits, with this command specifier.
    pub(super) fn encode(self, specifier: u8, body: &mut [u8]) -> Result<usize, Malformed> {
        let command = specifier | complete_bit(self.is_complete);
        let is_whole = self.size.is_none_or(|size| usize::try_from(size) == Ok(self.data.len()));
        let (command, size) = match (self.data.len(), self.size) {
            (1..=4, size) if is_whole => {
                let unused = u8::try_from(4_usize.saturating_sub(self.data.len())).unwrap_or(0);
                let told = if size.is_some() { unused << 2 | 0x01 } else { 0 };
                (command | 0x02 | told, None)
            }
            (_, Some(size)) => (command | 0x01, Some(size)),
            (_, None) => return Err(Malformed::WrongLength),
        };
        let mut body = Writer::new(body).put(&[command]).put(&place(self.address));
        if let Some(size) = size {
            body = body.put(&size.to_le_bytes());
        }
        body.put(self.data).pad_to(8).end()
    }
}

/// A request or answer without a value of its own.
pub(super) fn short(
    command: u8,
    address: Address,
    data: [u8; 4],
    body: &mut [u8],
) -> Result<usize, Malformed> {
    Writer::new(body).put(&[command]).put(&place(address)).put(&data).end()
}

/// Index and subindex, and what follows.
pub(super) fn entry(rest: &[u8]) -> Result<(Address, &[u8]), Malformed> {
    match rest {
        [low, high, subindex, rest @ ..] => {
            Ok((Address::new(u16::from_le_bytes([*low, *high]), *subindex), rest))
        }
        _ => Err(Malformed::TooShort),
    }
}

/// What an abort says.
pub(super) fn aborted(rest: &[u8]) -> Result<(Address, AbortCode), Malformed> {
    let (address, rest) = entry(rest)?;
    let (code, _) = rest.split_first_chunk::<4>().ok_or(Malformed::TooShort)?;
    Ok((address, AbortCode(u32::from_le_bytes(*code))))
}

pub(super) fn place(address: Address) -> [u8; 3] {
    let [low, high] = address.index.to_le_bytes();
    [low, high, address.subindex]
}

pub(super) const fn is_complete(command: u8) -> bool {
    command & 0x10 != 0
}

pub(super) const fn complete_bit(is_complete: bool) -> u8 {
    if is_complete { 0x10 } else { 0 }
}
