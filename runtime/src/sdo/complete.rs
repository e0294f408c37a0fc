//! Transfers of whole objects (ETG.1000.6, complete access).

use super::server::{check, found};
use super::values::Scratch;
use super::{AbortCode, CommunicationState, EntryInfo, Hooks, ObjectCode, ObjectInfo, Part, Server, Values};
use crate::bytes::WrongLength;
use crate::object::Address;

/// Subindex 0 takes two bytes in a complete access, all others their own.
const COUNT_WIDTH: usize = 2;

impl<V: Values, H: Hooks<V>> Server<V, H> {
    /// Reads the entries of an object from subindex 0 or 1 on, up to the number that subindex 0 says: one after
    /// another, each in whole bytes, subindex 0 in two. What cannot be read now is zero.
    pub fn upload_complete(
        &mut self,
        from: Address,
        state: CommunicationState,
        part: &mut Part<'_>,
    ) -> Result<(), AbortCode> {
        if part.is_first() {
            self.prepare_complete(from, state)?;
        }
        self.fill_complete(from, state, part)
    }

    /// Lets the firmware compute the entries that are going to be read.
    pub(crate) fn prepare_complete(
        &mut self,
        from: Address,
        state: CommunicationState,
    ) -> Result<(), AbortCode> {
        let object = whole::<V>(from)?;
        if !V::COMPLETE_ACCESS {
            return Err(AbortCode::UNSUPPORTED_ACCESS);
        }
        for entry in entries(object, from.subindex, u8::MAX) {
            if entry.subindex > 0 && entry.subindex > self.count(from.index)? {
                break;
            }
            if entry.access.check_read(state).is_ok() {
                let address = Address::new(from.index, entry.subindex);
                self.hooks.before_upload(&mut self.values, address)?;
            }
        }
        Ok(())
    }

    /// Reads a part of an object as it is.
    pub(crate) fn fill_complete(
        &mut self,
        from: Address,
        state: CommunicationState,
        part: &mut Part<'_>,
    ) -> Result<(), AbortCode> {
        let object = whole::<V>(from)?;
        if !V::COMPLETE_ACCESS {
            return Err(AbortCode::UNSUPPORTED_ACCESS);
        }
        let count = self.count(from.index)?;
        for entry in entries(object, from.subindex, count) {
            let end = part.total().saturating_add(width(entry));
            if entry.access.check_read(state).is_ok() {
                let found = found::<V>(Address::new(from.index, entry.subindex))?;
                part.put(self.value(found, &mut Scratch::default())?);
            }
            while part.total() < end {
                part.put(&[0]);
            }
        }
        Ok(())
    }

    /// Writes the entries of an object from subindex 0 or 1 on, as [`Server::upload_complete`] reads them. All are
    /// judged before the first is written; those that can only be read are passed over. The number of entries is
    /// written last.
    pub fn download_complete(
        &mut self,
        from: Address,
        state: CommunicationState,
        data: &[u8],
    ) -> Result<(), AbortCode> {
        let object = whole::<V>(from)?;
        if !V::COMPLETE_ACCESS {
            return Err(AbortCode::UNSUPPORTED_ACCESS);
        }
        let count = self.count_after(object, from, state, data)?;
        let pieces = |first: u8, last: u8| {
            let entries = entries(object, from.subindex, count);
            cut(from.index, entries, data).filter(move |(to, _)| (first..=last).contains(&to.subindex))
        };
        may_write(entries(object, from.subindex, count), state)?;
        let length = entries(object, from.subindex, count).map(width).fold(0, usize::saturating_add);
        if length != data.len() {
            return Err(WrongLength { expected: length, found: data.len() }.into());
        }
        for (to, data) in pieces(0, u8::MAX) {
            let found = found::<V>(to)?;
            if found.entry.access.check_write(state).is_ok() {
                check::<V>(found, data)?;
            }
        }
        for (to, data) in pieces(1, u8::MAX).chain(pieces(0, 0)) {
            let found = found::<V>(to)?;
            if found.entry.access.check_write(state).is_ok() {
                self.write(found, to, data)?;
            }
        }
        Ok(())
    }

    /// The number of entries after a download.
    fn count_after(
        &mut self,
        object: &ObjectInfo,
        from: Address,
        state: CommunicationState,
        data: &[u8],
    ) -> Result<u8, AbortCode> {
        let is_written = object.entry(0).is_some_and(|count| count.access.check_write(state).is_ok());
        match (from.subindex, data) {
            (0, [count, ..]) if is_written => Ok(*count),
            _ => self.count(from.index),
        }
    }

    /// The present number of entries.
    fn count(&mut self, index: u16) -> Result<u8, AbortCode> {
        let found = found::<V>(Address::new(index, 0))?;
        let mut scratch = Scratch::default();
        Ok(self.value(found, &mut scratch)?.first().copied().unwrap_or(0))
    }
}

/// The object, if it can be transferred as a whole. Those who call this ask once more whether the device does that at
/// all: so the compiler leaves out what comes after, where it does not.
fn whole<V: Values>(from: Address) -> Result<&'static ObjectInfo, AbortCode> {
    let object = V::TABLE.object(from.index).ok_or(AbortCode::NO_SUCH_OBJECT)?;
    if from.subindex > 1 {
        return Err(AbortCode::NO_SUCH_SUBINDEX);
    }
    if !V::COMPLETE_ACCESS || object.code == ObjectCode::Variable {
        return Err(AbortCode::UNSUPPORTED_ACCESS);
    }
    if object.entries.iter().any(|entry| entry.data_type.is_text()) {
        return Err(AbortCode::NO_COMPLETE_ACCESS);
    }
    Ok(object)
}

/// The entries from a subindex on, as many as there are.
fn entries(object: &ObjectInfo, first: u8, count: u8) -> impl Iterator<Item = &'static EntryInfo> + use<> {
    let entries = object.entries.iter().skip_while(move |entry| entry.subindex < first);
    entries.take_while(move |entry| entry.subindex == 0 || entry.subindex <= count)
}

/// The bytes that an entry takes.
fn width(entry: &EntryInfo) -> usize {
    if entry.subindex == 0 { COUNT_WIDTH } else { entry.bytes().into() }
}

/// The data of each entry.
fn cut(
    index: u16,
    mut entries: impl Iterator<Item = &'static EntryInfo>,
    mut data: &[u8],
) -> impl Iterator<Item = (Address, &[u8])> {
    core::iter::from_fn(move || {
        let entry = entries.next()?;
        let (piece, rest) = data.split_at_checked(width(entry))?;
        data = rest;
        Some((Address::new(index, entry.subindex), piece.get(..entry.bytes().into())?))
    })
}

/// Whether something of it can be written, and all of that in this state.
fn may_write(
    entries: impl Iterator<Item = &'static EntryInfo>,
    state: CommunicationState,
) -> Result<(), AbortCode> {
    let mut verdict = Err(AbortCode::READ_ONLY);
    for entry in entries {
        match entry.access.check_write(state) {
            Ok(()) => verdict = Ok(()),
            Err(AbortCode::READ_ONLY) => {}
            Err(error) => return Err(error),
        }
    }
    verdict
}
