//! Transfers of single entries.

use super::process_data::counts_process_data;
use super::values::Scratch;
use super::{AbortCode, CommunicationState, DataType, Found, Hooks, ObjectCode, Part, Range, Values};
use crate::object::Address;

/// The dictionary of a device as its SDO server has it: values, and what happens when they are read and written.
///
/// A transfer is judged in a fixed order, and the first fault is the one that is told: the object, its entry, the
/// right to read or write it, the communication state, the length, the bounds of the value, what process data may be
/// made of, and then the firmware (CiA 301, SDO abort codes; ETG.1000.6).
#[derive(Debug, Clone, Copy, Default)]
pub struct Server<V, H = ()> {
    /// The values, for the firmware as well as for the master.
    pub values: V,
    /// What the firmware does at a transfer.
    pub hooks: H,
}

impl<V: Values, H: Hooks<V>> Server<V, H> {
    /// A server of these values.
    pub const fn new(values: V, hooks: H) -> Self {
        Self { values, hooks }
    }

    /// Reads an entry: the bytes are in `buffer`, which has to hold them.
    pub fn upload<'b>(
        &mut self,
        address: Address,
        state: CommunicationState,
        buffer: &'b mut [u8],
    ) -> Result<&'b [u8], AbortCode> {
        let mut part = Part::new(buffer, 0);
        self.read(address, state, &mut part)?;
        if part.is_last() { Ok(part.bytes()) } else { Err(AbortCode::OUT_OF_MEMORY) }
    }

    /// Reads a part of an entry; the value is computed with the first.
    pub fn read(
        &mut self,
        address: Address,
        state: CommunicationState,
        part: &mut Part<'_>,
    ) -> Result<(), AbortCode> {
        if part.is_first() {
            self.prepare(address, state)?;
        }
        self.fill(address, state, part)
    }

    /// Lets the firmware compute an entry that is going to be read.
    pub(crate) fn prepare(&mut self, address: Address, state: CommunicationState) -> Result<(), AbortCode> {
        found(&self.values, address)?.entry.access.check_read(state)?;
        self.hooks.before_upload(&mut self.values, address)
    }

    /// Reads a part of an entry as it is.
    pub(crate) fn fill(
        &mut self,
        address: Address,
        state: CommunicationState,
        part: &mut Part<'_>,
    ) -> Result<(), AbortCode> {
        let found = found(&self.values, address)?;
        found.entry.access.check_read(state)?;
        part.put(self.value(found, &mut Scratch::default())?);
        Ok(())
    }

    /// Writes an entry, with data of just its length; a text may be shorter.
    pub fn download(
        &mut self,
        address: Address,
        state: CommunicationState,
        data: &[u8],
    ) -> Result<(), AbortCode> {
        let found = found(&self.values, address)?;
        found.entry.access.check_write(state)?;
        check(&self.values, found, address, data)?;
        self.judge(address, data)?;
        self.write(found, address, data)
    }

    /// Whether data of this length may be written to an entry at all, in bytes.
    pub(crate) fn expect_download(
        &self,
        address: Address,
        state: CommunicationState,
        length: usize,
    ) -> Result<(), AbortCode> {
        let found = found(&self.values, address)?;
        found.entry.access.check_write(state)?;
        if length > usize::from(found.entry.bytes()) { Err(AbortCode::LENGTH_TOO_HIGH) } else { Ok(()) }
    }

    /// Writes what the table allows, if the firmware allows it.
    pub(super) fn write(&mut self, found: Found, address: Address, data: &[u8]) -> Result<(), AbortCode> {
        let place = found.place().ok_or(AbortCode::READ_ONLY)?;
        self.hooks.before_download(&mut self.values, address, data)?;
        self.values.slot(place).ok_or(AbortCode::DEVICE_INCOMPATIBLE)?.store(data)?;
        self.hooks.after_download(&mut self.values, address);
        Ok(())
    }

    /// The present value as an SDO carries it; a text without the zeros that fill it up.
    pub(super) fn value<'s>(
        &'s mut self,
        found: Found,
        scratch: &'s mut Scratch,
    ) -> Result<&'s [u8], AbortCode> {
        let Some(place) = found.place() else {
            return Ok(self.values.table().constant(found).unwrap_or_default());
        };
        let slot = self.values.slot(place).ok_or(AbortCode::DEVICE_INCOMPATIBLE)?;
        let bytes = slot.bytes(scratch);
        let bytes = bytes.get(..found.entry.bytes().into()).unwrap_or(bytes);
        if !found.entry.data_type.is_text() {
            return Ok(bytes);
        }
        let end = bytes.iter().rposition(|byte| *byte != 0).map_or(0, |last| last.saturating_add(1));
        Ok(bytes.get(..end).unwrap_or(bytes))
    }
}

/// Finds an entry. Lookups are inlined; those of the server are all made here, so that a firmware has one.
pub(crate) fn found(values: &impl Values, address: Address) -> Result<Found, AbortCode> {
    values.table().find(address)
}

/// Whether data has the length and the value that the table asks for.
pub(super) fn check(
    values: &impl Values,
    found: Found,
    address: Address,
    data: &[u8],
) -> Result<(), AbortCode> {
    let (entry, length) = (found.entry, usize::from(found.entry.bytes()));
    if data.len() > length {
        return Err(AbortCode::LENGTH_TOO_HIGH);
    }
    if data.len() < length && !entry.data_type.is_text() {
        return Err(AbortCode::LENGTH_TOO_LOW);
    }
    if !counts_process_data(values, address) && !fits(found, data) {
        return Err(AbortCode::VALUE_TOO_HIGH);
    }
    let limits = found.place().and_then(|place| Range::of(values.ranges(), place));
    limits.map_or(Ok(()), |limits| limits.check(data))
}

/// Whether a group of bits has no bits above its width, and a number of entries no more than there are.
fn fits(found: Found, data: &[u8]) -> bool {
    let (object, entry) = (found.object, found.entry);
    let [byte] = data else { return true };
    let is_count = entry.subindex == 0 && object.code != ObjectCode::Variable;
    if is_count && entry.data_type == DataType::UNSIGNED8 {
        return *byte <= object.highest_subindex();
    }
    entry.data_type == DataType::BOOLEAN || u32::from(*byte).checked_shr(entry.bits.into()).unwrap_or(0) == 0
}
