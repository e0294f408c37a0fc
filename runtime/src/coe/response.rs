//! What a device answers.

use super::request::{Started, aborted, complete_bit, entry, is_complete, short};
use super::segment::{Segment, toggle, toggle_bit};
use super::writer::Writer;
use super::{Envelope, Malformed, Service};
use crate::object::Address;
use crate::sdo::AbortCode;

/// The answer to an SDO request (ETG.1000.6, SDO services).
///
/// ```
/// use devc_runtime::coe::{Envelope, Response, Service};
/// use devc_runtime::object::Address;
///
/// let value = 0x0002_0192_u32.to_le_bytes();
/// let response = Response::Uploaded {
///     address: Address::new(0x1000, 0),
///     is_complete: false,
///     size: Some(4),
///     data: &value,
/// };
/// let mut frame = [0; 16];
/// assert_eq!(response.encode(Envelope::new(Service::SDO_RESPONSE), &mut frame), Ok(16));
/// assert_eq!(frame[8..], [0x43, 0x00, 0x10, 0, 0x92, 0x01, 0x02, 0x00]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Response<'a> {
    /// The value, or the first part of it, was written.
    Downloaded {
        /// The entry.
        address: Address,
        /// Whether it was the whole object from the entry on.
        is_complete: bool,
    },
    /// A further part was taken.
    SegmentDownloaded {
        /// As in the request.
        toggle: bool,
    },
    /// The value, or the first part of it.
    Uploaded {
        /// The entry.
        address: Address,
        /// Whether it is the whole object from the entry on.
        is_complete: bool,
        /// The bytes of the whole value; none if they are not told.
        size: Option<u32>,
        /// The bytes of it that are here; the rest is asked for in segments.
        data: &'a [u8],
    },
    /// A further part of the value.
    SegmentUploaded {
        /// As in the request.
        toggle: bool,
        /// Whether the value ends with it.
        is_last: bool,
        /// The bytes that are here.
        data: &'a [u8],
    },
    /// The transfer is refused or given up.
    Abort {
        /// The entry.
        address: Address,
        /// Why.
        code: AbortCode,
    },
}

impl<'a> Response<'a> {
    /// Reads what is in the envelope of an answer, or of an abort, which travels as a request.
    pub fn decode(body: &'a [u8]) -> Result<Self, Malformed> {
        let (command, rest) = body.split_first().ok_or(Malformed::TooShort)?;
        match command >> 5 {
            0 => {
                let Segment { toggle, is_last, data } = Segment::decode(*command, rest)?;
                Ok(Self::SegmentUploaded { toggle, is_last, data })
            }
            1 => Ok(Self::SegmentDownloaded { toggle: toggle(*command) }),
            2 => {
                let Started { address, is_complete, size, data } = Started::decode(*command, rest)?;
                Ok(Self::Uploaded { address, is_complete, size, data })
            }
            3 => {
                let (address, _) = entry(rest)?;
                Ok(Self::Downloaded { address, is_complete: is_complete(*command) })
            }
            4 => {
                let (address, code) = aborted(rest)?;
                Ok(Self::Abort { address, code })
            }
            _ => Err(Malformed::UnknownCommand(*command)),
        }
    }

    /// Writes the answer, with this envelope around it, and tells the length of the message. An abort goes out as a
    /// request, as the standard has it.
    pub fn encode(&self, envelope: Envelope, frame: &mut [u8]) -> Result<usize, Malformed> {
        let body = Envelope::body(frame);
        let length = match *self {
            Self::Downloaded { address, is_complete } => {
                short(0x60 | complete_bit(is_complete), address, [0; 4], body)?
            }
            Self::SegmentDownloaded { toggle } => {
                Writer::new(body).put(&[0x20 | toggle_bit(toggle)]).pad_to(8).end()?
            }
            Self::Uploaded { address, is_complete, size, data } => {
                Started { address, is_complete, size, data }.encode(0x40, body)?
            }
            Self::SegmentUploaded { toggle, is_last, data } => {
                Segment { toggle, is_last, data }.encode(body)?
            }
            Self::Abort { address, code } => short(0x80, address, code.0.to_le_bytes(), body)?,
        };
        let is_abort = matches!(self, Self::Abort { .. });
        let service = if is_abort { Service::SDO_REQUEST } else { Service::SDO_RESPONSE };
        Envelope { service, ..envelope }.seal(frame, length)
    }
}
