//! What a device says unasked when something is wrong.

use super::writer::Writer;
use super::{Envelope, Malformed, Service};

/// An emergency message (ETG.1000.6, emergency; CiA 301, emergency object).
///
/// ```
/// use devc_runtime::coe::{Emergency, Envelope, Service};
///
/// let emergency = Emergency { code: 0x7121, register: 0x21, data: [1, 2, 3, 4, 5] };
/// let mut frame = [0; 16];
/// assert_eq!(emergency.encode(Envelope::new(Service::EMERGENCY), &mut frame), Ok(16));
/// assert_eq!(frame[7..], [0x10, 0x21, 0x71, 0x21, 1, 2, 3, 4, 5]);
/// assert_eq!(Emergency::decode(&frame[8..]), Ok(emergency));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Emergency {
    /// What is wrong: an error code as in 0x603F; 0 when nothing is any more.
    pub code: u16,
    /// The error register, 0x1001.
    pub register: u8,
    /// What the vendor adds.
    pub data: [u8; 5],
}

impl Emergency {
    /// Reads what is in the envelope.
    pub fn decode(body: &[u8]) -> Result<Self, Malformed> {
        match body {
            [low, high, register, a, b, c, d, e, ..] => {
                let code = u16::from_le_bytes([*low, *high]);
                Ok(Self { code, register: *register, data: [*a, *b, *c, *d, *e] })
            }
            _ => Err(Malformed::TooShort),
        }
    }

    /// Writes the message, with this envelope around it, and tells its length.
    pub fn encode(&self, envelope: Envelope, frame: &mut [u8]) -> Result<usize, Malformed> {
        let body = Writer::new(Envelope::body(frame));
        let length = body.put(&self.code.to_le_bytes()).put(&[self.register]).put(&self.data).end()?;
        Envelope { service: Service::EMERGENCY, ..envelope }.seal(frame, length)
    }
}
