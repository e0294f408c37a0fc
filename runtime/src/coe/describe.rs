//! SDO information as a device gives it.

use super::envelope::{Envelope, Malformed, Service};
use super::mailbox::Mailbox;
use super::request::entry;
use super::transfer::Transfer;
use super::writer::Writer;
use super::{EntryDescription, Information, ListKind, ObjectDescription, Operation};
use crate::sdo::{
    AbortCode, Access, DataType, Dictionary, Found, Hooks, Names, ObjectCode, ObjectInfo, Range, Values,
    found,
};

/// Bytes in front of the indices of a piece; those after the first have two less.
const LIST_HEAD: usize = 14;

impl<V: Values, H: Hooks<V>, const BUFFER: usize> Mailbox<V, H, BUFFER> {
    /// Answers a question about the dictionary.
    pub(super) fn information(
        &mut self,
        envelope: Envelope,
        body: &[u8],
        answer: &mut [u8],
    ) -> Result<usize, Malformed> {
        let asked = Information::decode(body)?;
        let answered = match (self.names, asked.operation) {
            (None, _) => Err(AbortCode::UNSUPPORTED_ACCESS),
            (_, Operation::GetList) => Ok(self.list(asked.data, envelope, answer)?),
            (Some(names), Operation::GetObject) => {
                object(&self.server.values, names, asked.data, envelope, answer)?
            }
            (Some(names), Operation::GetEntry) => {
                described(&self.server.values, names, asked.data, envelope, answer)?
            }
            _ => Err(AbortCode::UNKNOWN_COMMAND_SPECIFIER),
        };
        answered.or_else(|code| {
            Information::new(Operation::Error, &code.0.to_le_bytes()).encode(envelope, answer)
        })
    }

    fn list(&mut self, asked: &[u8], envelope: Envelope, answer: &mut [u8]) -> Result<usize, Malformed> {
        let kind = asked.first_chunk::<2>().ok_or(Malformed::TooShort)?;
        let Some(kind) = ListKind::of(u16::from_le_bytes(*kind)) else {
            let code = AbortCode::VALUE_OUT_OF_RANGE.0.to_le_bytes();
            return Information::new(Operation::Error, &code).encode(envelope, answer);
        };
        if kind == ListKind::Counts {
            return counts(self.server.values.table(), envelope, answer);
        }
        self.transfer = Transfer::List { kind, done: 0 };
        self.list_piece(envelope, answer)
    }

    /// The next piece of a list that is under way; nothing if none is.
    pub(super) fn list_piece(&mut self, envelope: Envelope, answer: &mut [u8]) -> Result<usize, Malformed> {
        let Transfer::List { kind, done } = self.transfer else { return Ok(0) };
        let room = answer.len().saturating_sub(LIST_HEAD) / 2;
        let left = usize::from(count(self.server.values.table(), kind)).saturating_sub(done);
        let here = left.min(room);
        let fragments = left.saturating_sub(here).checked_div(room).ok_or(Malformed::NoRoom)?;
        let is_uneven = left.saturating_sub(here).checked_rem(room) != Some(0);
        let fragments = u16::try_from(fragments.saturating_add(is_uneven.into())).unwrap_or(u16::MAX);
        self.transfer = match fragments {
            0 => Transfer::None,
            _ => Transfer::List { kind, done: done.saturating_add(here) },
        };
        let head = Information { operation: Operation::List, fragments_left: fragments, data: &[] }.head();
        let mut body = Writer::new(Envelope::body(answer)).put(&head);
        if done == 0 {
            body = body.put(&(kind as u16).to_le_bytes());
        }
        for (index, _) in listed(self.server.values.table(), kind).skip(done).take(here) {
            body = body.put(&index.to_le_bytes());
        }
        let length = body.end()?;
        Envelope { service: Service::SDO_INFORMATION, ..envelope }.seal(answer, length)
    }
}

/// The numbers of objects in each list.
fn counts(table: &Dictionary, envelope: Envelope, answer: &mut [u8]) -> Result<usize, Malformed> {
    let head = Information::new(Operation::List, &[]).head();
    let kind = (ListKind::Counts as u16).to_le_bytes();
    let body = Writer::new(Envelope::body(answer)).put(&head).put(&kind);
    let body =
        ListKind::LISTS.into_iter().fold(body, |body, kind| body.put(&count(table, kind).to_le_bytes()));
    let length = body.end()?;
    Envelope { service: Service::SDO_INFORMATION, ..envelope }.seal(answer, length)
}

/// The objects of a list.
fn listed(table: &Dictionary, kind: ListKind) -> impl Iterator<Item = (u16, &'static ObjectInfo)> + use<> {
    let right = match kind {
        ListKind::Counts | ListKind::All => None,
        ListKind::RxPdo => Some(Access::RX_PDO),
        ListKind::TxPdo => Some(Access::TX_PDO),
        ListKind::Backup => Some(Access::BACKUP),
        ListKind::Settings => Some(Access::SETTING),
    };
    table.objects().filter(move |(_, object)| {
        right.is_none_or(|right| object.entries.iter().any(|entry| entry.access.includes(right)))
    })
}

fn count(table: &Dictionary, kind: ListKind) -> u16 {
    listed(table, kind).fold(0, |count, _| count.saturating_add(1))
}

/// A question may be refused, and an answer may not fit.
type Answered = Result<Result<usize, AbortCode>, Malformed>;

fn object(
    values: &impl Values,
    names: &Names,
    asked: &[u8],
    envelope: Envelope,
    answer: &mut [u8],
) -> Answered {
    let index = u16::from_le_bytes(*asked.first_chunk::<2>().ok_or(Malformed::TooShort)?);
    let Some(object) = values.table().object(index) else { return Ok(Err(AbortCode::NO_SUCH_OBJECT)) };
    let single = object.entries.first().filter(|_| object.code == ObjectCode::Variable);
    let description = ObjectDescription {
        index,
        data_type: single.map_or(DataType(0), |entry| entry.data_type),
        highest_subindex: object.highest_subindex(),
        code: object.code as u8,
        name: names.object(values.table(), index).as_bytes(),
    };
    description.encode(envelope, answer).map(Ok)
}

fn described(
    values: &impl Values,
    names: &Names,
    asked: &[u8],
    envelope: Envelope,
    answer: &mut [u8],
) -> Answered {
    let (address, wanted) = entry(asked)?;
    let found = match found(values, address) {
        Ok(found) => found,
        Err(code) => return Ok(Err(code)),
    };
    let mut buffer = [0; 24];
    let (value_info, length) = tell(values, found, wanted.first().copied().unwrap_or(0), &mut buffer)?;
    let description = EntryDescription {
        address,
        value_info,
        data_type: found.entry.data_type,
        bits: found.entry.bits,
        access: found.entry.access,
        values: buffer.get(..length).unwrap_or_default(),
        name: names.entry(values.table(), address).as_bytes(),
    };
    description.encode(envelope, answer).map(Ok)
}

/// Writes those of the values asked for that there are, and tells which these are and how many bytes.
fn tell(
    values: &impl Values,
    found: Found,
    asked: u8,
    buffer: &mut [u8; 24],
) -> Result<(u8, usize), Malformed> {
    let length = usize::from(found.entry.bytes());
    let limits =
        found.place().and_then(|place| Range::of(values.ranges(), place)).map(|limits| limits.bytes(length));
    let (least, greatest) = limits.map_or((None, None), |[least, greatest]| (Some(least), Some(greatest)));
    let default = values.table().constant(found).filter(|_| !found.entry.data_type.is_text());
    let told_of = [
        (0x10, default),
        (0x20, least.as_ref().map(<[u8; 8]>::as_slice)),
        (0x40, greatest.as_ref().map(<[u8; 8]>::as_slice)),
    ];
    let (mut told, mut writer) = (0, Writer::new(buffer));
    for (bit, value) in told_of.into_iter().filter(|(bit, _)| asked & bit != 0) {
        if let Some(value) = value.and_then(|value| value.get(..length)) {
            (told, writer) = (told | bit, writer.put(value));
        }
    }
    Ok((told, writer.end()?))
}
