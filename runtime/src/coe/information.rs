//! What is in a dictionary, asked and answered (ETG.1000.6, SDO information services).

use super::request::{entry, place};
use super::writer::Writer;
use super::{Envelope, Malformed, Service};
use crate::object::Address;
use crate::sdo::{AbortCode, Access, DataType};

/// A message of the SDO information services, in one piece or in several.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Information<'a> {
    /// What is asked or answered.
    pub operation: Operation,
    /// How many further pieces of the answer follow.
    pub fragments_left: u16,
    /// What the operation says:
    ///
    /// - a list is asked for by its [kind](ListKind); the answer repeats the kind, in the first piece only, and goes
    ///   on with indices of two bytes each
    /// - an object is asked for by its index; the answer is an [`ObjectDescription`]
    /// - an entry is asked for by index, subindex and a byte of what is wanted besides; the answer is an
    ///   [`EntryDescription`]
    /// - an error is an abort code of four bytes
    pub data: &'a [u8],
}

/// What is asked or answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum Operation {
    /// Asks for the indices of objects.
    GetList = 1,
    /// The indices.
    List = 2,
    /// Asks about an object.
    GetObject = 3,
    /// What there is to know of it.
    Object = 4,
    /// Asks about an entry.
    GetEntry = 5,
    /// What there is to know of it.
    Entry = 6,
    /// The question is refused.
    Error = 7,
}

impl Operation {
    const fn of(number: u8) -> Option<Self> {
        match number {
            1 => Some(Self::GetList),
            2 => Some(Self::List),
            3 => Some(Self::GetObject),
            4 => Some(Self::Object),
            5 => Some(Self::GetEntry),
            6 => Some(Self::Entry),
            7 => Some(Self::Error),
            _ => None,
        }
    }
}

impl<'a> Information<'a> {
    /// Bytes in front of the data.
    pub(super) const HEAD: usize = 4;

    /// A message in one piece.
    pub const fn new(operation: Operation, data: &'a [u8]) -> Self {
        Self { operation, fragments_left: 0, data }
    }

    /// Reads what is in the envelope.
    pub fn decode(body: &'a [u8]) -> Result<Self, Malformed> {
        let [operation, _, low, high, data @ ..] = body else { return Err(Malformed::TooShort) };
        let known = Operation::of(operation & 0x7F).ok_or(Malformed::UnknownCommand(*operation))?;
        Ok(Self { operation: known, fragments_left: u16::from_le_bytes([*low, *high]), data })
    }

    /// Writes the message, with this envelope around it, and tells its length.
    pub fn encode(&self, envelope: Envelope, frame: &mut [u8]) -> Result<usize, Malformed> {
        let body = Envelope::body(frame);
        let length = Writer::new(body).put(&self.head()).put(self.data).end()?;
        Envelope { service: Service::SDO_INFORMATION, ..envelope }.seal(frame, length)
    }

    /// Operation, whether more follows, and how much.
    pub(super) fn head(&self) -> [u8; 4] {
        let incomplete = if self.fragments_left > 0 { 0x80 } else { 0 };
        let [low, high] = self.fragments_left.to_le_bytes();
        [self.operation as u8 | incomplete, 0, low, high]
    }

    /// The abort code of an error.
    pub fn abort_code(&self) -> Option<AbortCode> {
        let code = self.data.first_chunk::<4>().filter(|_| self.operation == Operation::Error)?;
        Some(AbortCode(u32::from_le_bytes(*code)))
    }
}

/// Which objects a list has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u16)]
pub enum ListKind {
    /// None: the numbers of objects in the other five lists.
    Counts = 0,
    /// All.
    All = 1,
    /// Those that can be mapped to what the device receives.
    RxPdo = 2,
    /// Those that can be mapped to what the device sends.
    TxPdo = 3,
    /// Those that are kept for a device which replaces this one.
    Backup = 4,
    /// Those that are settings.
    Settings = 5,
}

impl ListKind {
    /// The kinds of objects, in the order in which their numbers are told.
    pub const LISTS: [Self; 5] = [Self::All, Self::RxPdo, Self::TxPdo, Self::Backup, Self::Settings];

    /// The kind with this number.
    pub fn of(number: u16) -> Option<Self> {
        let mut kinds = [Self::Counts].into_iter().chain(Self::LISTS);
        kinds.find(|kind| *kind as u16 == number)
    }
}

/// The answer about an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ObjectDescription<'a> {
    /// Its index.
    pub index: u16,
    /// Its type; of an object with several entries 0, or the number of a type for the whole.
    pub data_type: DataType,
    /// Its highest subindex.
    pub highest_subindex: u8,
    /// What kind of object it is, see [`ObjectCode`](crate::sdo::ObjectCode).
    pub code: u8,
    /// Its name.
    pub name: &'a [u8],
}

impl<'a> ObjectDescription<'a> {
    /// Reads the data of the answer.
    pub fn decode(data: &'a [u8]) -> Result<Self, Malformed> {
        match data {
            [low, high, type_low, type_high, highest_subindex, code, name @ ..] => Ok(Self {
                index: u16::from_le_bytes([*low, *high]),
                data_type: DataType(u16::from_le_bytes([*type_low, *type_high])),
                highest_subindex: *highest_subindex,
                code: *code,
                name,
            }),
            _ => Err(Malformed::TooShort),
        }
    }

    /// Writes the answer, with this envelope around it, and tells the length of the message. Of the name as much is
    /// written as there is room for.
    pub fn encode(&self, envelope: Envelope, frame: &mut [u8]) -> Result<usize, Malformed> {
        let [low, high] = self.index.to_le_bytes();
        let [type_low, type_high] = self.data_type.0.to_le_bytes();
        let facts = [low, high, type_low, type_high, self.highest_subindex, self.code];
        described(Operation::Object, &facts, &[], self.name, envelope, frame)
    }
}

/// The answer about an entry.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EntryDescription<'a> {
    /// Its address.
    pub address: Address,
    /// What else is told: bit 3 the unit, 4 the default, 5 the least and 6 the greatest value. A
    /// [`Mailbox`](super::Mailbox) tells the bounds of what can be written and the default of what never changes, if
    /// asked; it never tells a unit.
    pub value_info: u8,
    /// Its type.
    pub data_type: DataType,
    /// Its length in bits.
    pub bits: u16,
    /// What may be done with it.
    pub access: Access,
    /// The default, the least and the greatest value, those of them that are told, each in the bytes of the type.
    pub values: &'a [u8],
    /// Its name; if the unit is told, that and the values come first, and `values` is empty.
    pub name: &'a [u8],
}

impl<'a> EntryDescription<'a> {
    /// Reads the data of the answer.
    pub fn decode(data: &'a [u8]) -> Result<Self, Malformed> {
        let (address, rest) = entry(data)?;
        match rest {
            [value_info, type_low, type_high, low, high, access_low, access_high, rest @ ..] => {
                let bits = u16::from_le_bytes([*low, *high]);
                let told = if value_info & 0x08 == 0 { (value_info & 0x70).count_ones() } else { 0 };
                let length = (0..told).fold(0, |sum: usize, _| sum.saturating_add(bits.div_ceil(8).into()));
                let (values, name) = rest.split_at_checked(length).ok_or(Malformed::TooShort)?;
                let data_type = DataType(u16::from_le_bytes([*type_low, *type_high]));
                let access = Access(u16::from_le_bytes([*access_low, *access_high]));
                Ok(Self { address, value_info: *value_info, data_type, bits, access, values, name })
            }
            _ => Err(Malformed::TooShort),
        }
    }

    /// Writes the answer, with this envelope around it, and tells the length of the message. Of the name as much is
    /// written as there is room for.
    pub fn encode(&self, envelope: Envelope, frame: &mut [u8]) -> Result<usize, Malformed> {
        let [low, high, subindex] = place(self.address);
        let [type_low, type_high] = self.data_type.0.to_le_bytes();
        let [bits_low, bits_high] = self.bits.to_le_bytes();
        let [access_low, access_high] = self.access.0.to_le_bytes();
        let facts = [
            low,
            high,
            subindex,
            self.value_info,
            type_low,
            type_high,
            bits_low,
            bits_high,
            access_low,
            access_high,
        ];
        described(Operation::Entry, &facts, self.values, self.name, envelope, frame)
    }
}

/// An answer of facts, values and a name, which is cut where the mailbox ends.
fn described(
    operation: Operation,
    facts: &[u8],
    values: &[u8],
    name: &[u8],
    envelope: Envelope,
    frame: &mut [u8],
) -> Result<usize, Malformed> {
    let head = Envelope::SIZE
        .saturating_add(Information::HEAD)
        .saturating_add(facts.len())
        .saturating_add(values.len());
    let room = frame.len().saturating_sub(head);
    let name = name.get(..room).unwrap_or(name);
    let body = Writer::new(Envelope::body(frame));
    let length = body.put(&Information::new(operation, &[]).head()).put(facts).put(values).put(name).end()?;
    Envelope { service: Service::SDO_INFORMATION, ..envelope }.seal(frame, length)
}
