//! What is around every message: the headers of the mailbox and of CoE.

use core::fmt;

use super::writer::Writer;

/// What a mailbox message carries, by number (ETG.1000.4, mailbox header, type).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Protocol(pub u8);

impl Protocol {
    /// A complaint about a message.
    pub const ERROR: Self = Self(0);
    /// ADS.
    pub const AOE: Self = Self(1);
    /// Ethernet.
    pub const EOE: Self = Self(2);
    /// CANopen.
    pub const COE: Self = Self(3);
    /// Files.
    pub const FOE: Self = Self(4);
    /// The servo drive profile.
    pub const SOE: Self = Self(5);
    /// What a vendor defines.
    pub const VOE: Self = Self(15);
}

/// What a CoE message is about, by number (ETG.1000.6, CoE header, service).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Service(pub u8);

impl Service {
    /// An emergency message of a device.
    pub const EMERGENCY: Self = Self(1);
    /// An SDO request; an abort is one too, whoever sends it.
    pub const SDO_REQUEST: Self = Self(2);
    /// The answer to an SDO request.
    pub const SDO_RESPONSE: Self = Self(3);
    /// A TxPDO.
    pub const TX_PDO: Self = Self(4);
    /// An RxPDO.
    pub const RX_PDO: Self = Self(5);
    /// Asks for a TxPDO.
    pub const TX_PDO_REQUEST: Self = Self(6);
    /// Asks for an RxPDO.
    pub const RX_PDO_REQUEST: Self = Self(7);
    /// What is in the dictionary: asked, and answered.
    pub const SDO_INFORMATION: Self = Self(8);
}

/// The headers of a CoE message (ETG.1000.4, mailbox header; ETG.1000.6, CoE header).
///
/// ```
/// use devc_runtime::coe::{Envelope, Service};
///
/// let envelope = Envelope { counter: 3, ..Envelope::new(Service::SDO_REQUEST) };
/// let mut frame = [0; 16];
/// assert_eq!(envelope.seal(&mut frame, 8), Ok(16));
/// assert_eq!(frame[..8], [0x0A, 0, 0, 0, 0, 0x33, 0, 0x20]);
/// assert_eq!(Envelope::open(&frame), Ok((envelope, [0; 8].as_slice())));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Envelope {
    /// The station that sends or gets it; 0 is the master.
    pub address: u16,
    /// Reserved, 0 to 63.
    pub channel: u8,
    /// 0, the lowest, to 3.
    pub priority: u8,
    /// 1 to 7, one more from message to message, then again 1; 0 if messages are not counted.
    pub counter: u8,
    /// The number of a PDO, to 511; 0 for all other services.
    pub number: u16,
    /// What it is about.
    pub service: Service,
}

impl Envelope {
    /// Bytes of both headers.
    pub const SIZE: usize = 8;

    /// Bytes of the mailbox header alone, which its length does not count.
    const MAILBOX_SIZE: usize = 6;

    /// The envelope of a master's message, or of a device's to a master, with everything 0 but the service.
    pub const fn new(service: Service) -> Self {
        Self { address: 0, channel: 0, priority: 0, counter: 0, number: 0, service }
    }

    /// The headers and what is in them. What lies in the mailbox behind the message is left out.
    pub fn open(frame: &[u8]) -> Result<(Self, &[u8]), Malformed> {
        let (header, rest) = frame.split_first_chunk::<6>().ok_or(Malformed::TooShort)?;
        let [length_low, length_high, low, high, priority, counter] = *header;
        let length = u16::from_le_bytes([length_low, length_high]);
        let content = rest.get(..usize::from(length)).ok_or(Malformed::WrongLength)?;
        let protocol = Protocol(counter & 0x0F);
        if protocol != Protocol::COE {
            return Err(Malformed::OtherProtocol(protocol));
        }
        let (coe, body) = content.split_first_chunk::<2>().ok_or(Malformed::TooShort)?;
        let [_, service] = *coe;
        let envelope = Self {
            address: u16::from_le_bytes([low, high]),
            channel: priority & 0x3F,
            priority: priority >> 6,
            counter: counter >> 4 & 0x07,
            number: u16::from_le_bytes(*coe) & 0x01FF,
            service: Service(service >> 4),
        };
        Ok((envelope, body))
    }

    /// The counter of a message of any protocol; 0 if it is not counted.
    pub(super) fn counter(frame: &[u8]) -> u8 {
        frame.get(5).map_or(0, |last| last >> 4 & 0x07)
    }

    /// Writes the headers in front of so many bytes that are there already, and tells the length of the message.
    /// What does not fit its field is cut off.
    pub fn seal(self, frame: &mut [u8], body: usize) -> Result<usize, Malformed> {
        let length = Self::SIZE.saturating_add(body);
        if frame.len() < length {
            return Err(Malformed::NoRoom);
        }
        let content = length.saturating_sub(Self::MAILBOX_SIZE);
        let content = u16::try_from(content).map_err(|_| Malformed::WrongLength)?;
        let coe = u16::from(self.service.0 & 0x0F) << 12 | self.number & 0x01FF;
        Writer::new(frame)
            .put(&content.to_le_bytes())
            .put(&self.address.to_le_bytes())
            .put(&[self.priority << 6 | self.channel & 0x3F])
            .put(&[(self.counter & 0x07) << 4 | Protocol::COE.0])
            .put(&coe.to_le_bytes())
            .end()?;
        Ok(length)
    }

    /// Where what is in the envelope begins.
    pub(super) fn body(frame: &mut [u8]) -> &mut [u8] {
        frame.get_mut(Self::SIZE..).unwrap_or_default()
    }
}

/// What a device answers to a message that it cannot read (ETG.1000.4, mailbox error reply).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct MailboxError(pub u16);

impl MailboxError {
    /// The header is wrong.
    pub const SYNTAX: Self = Self(1);
    /// The protocol is not supported.
    pub const UNSUPPORTED_PROTOCOL: Self = Self(2);
    /// The service is not supported.
    pub const SERVICE_NOT_SUPPORTED: Self = Self(4);
    /// The length is less than the protocol needs.
    pub const TOO_SHORT: Self = Self(6);
    /// The length does not go with the mailbox.
    pub const INVALID_SIZE: Self = Self(8);

    /// Writes the answer and tells its length.
    pub fn encode(self, counter: u8, frame: &mut [u8]) -> Result<usize, Malformed> {
        let header = [4, 0, 0, 0, 0, (counter & 0x07) << 4 | Protocol::ERROR.0];
        Writer::new(frame).put(&header).put(&[1, 0]).put(&self.0.to_le_bytes()).end()
    }
}

/// Why a message cannot be read or written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Malformed {
    /// There is less than the headers say, or than the service needs.
    TooShort,
    /// The length is not that of the content.
    WrongLength,
    /// It is no CoE message.
    OtherProtocol(Protocol),
    /// The service has no such command or operation.
    UnknownCommand(u8),
    /// The message does not fit the mailbox.
    NoRoom,
}

impl From<Malformed> for MailboxError {
    fn from(malformed: Malformed) -> Self {
        match malformed {
            Malformed::TooShort => Self::TOO_SHORT,
            Malformed::WrongLength | Malformed::NoRoom => Self::INVALID_SIZE,
            Malformed::OtherProtocol(_) => Self::UNSUPPORTED_PROTOCOL,
            Malformed::UnknownCommand(_) => Self::SERVICE_NOT_SUPPORTED,
        }
    }
}

impl fmt::Display for Malformed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooShort => f.write_str("the message ends too early"),
            Self::WrongLength => f.write_str("the length is not that of the content"),
            Self::OtherProtocol(Protocol(number)) => write!(f, "expected protocol 3 (CoE), found {number}"),
            Self::UnknownCommand(command) => write!(f, "unknown command 0x{command:02X}"),
            Self::NoRoom => f.write_str("the message does not fit the mailbox"),
        }
    }
}

impl core::error::Error for Malformed {}
