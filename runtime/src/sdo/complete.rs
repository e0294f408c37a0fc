//! Transfers of whole objects (ETG.1000.6, complete access).

use super::layout::{Bits, Places, piece};
use super::server::{check, found};
use super::values::Scratch;
use super::{AbortCode, CommunicationState, EntryInfo, Hooks, ObjectCode, ObjectInfo, Part, Server, Values};
use crate::bytes::WrongLength;
use crate::object::Address;

impl<V: Values, H: Hooks<V>> Server<V, H> {
    /// Reads the entries of an object from subindex 0 or 1 on, up to the number that subindex 0 says, as they lie in the
    /// object's type in the ESI file: subindex 0 takes two bytes, entries of less than a byte are side by side, and all
    /// others begin at a byte. What cannot be read now is zero.
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
        let object = whole(&self.values, from)?;
        if !self.values.has_complete_access() {
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
        let object = whole(&self.values, from)?;
        if !self.values.has_complete_access() {
            return Err(AbortCode::UNSUPPORTED_ACCESS);
        }
        let count = self.count(from.index)?;
        let mut bits = Bits::new(part);
        for entry in entries(object, from.subindex, count) {
            let mut scratch = Scratch::default();
            let value = match entry.access.check_read(state) {
                Ok(()) => {
                    self.value(found(&self.values, Address::new(from.index, entry.subindex))?, &mut scratch)?
                }
                Err(_) => &[],
            };
            bits.put(entry, value);
        }
        bits.end();
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
        let object = whole(&self.values, from)?;
        if !self.values.has_complete_access() {
            return Err(AbortCode::UNSUPPORTED_ACCESS);
        }
        let count = self.count_after(object, from, state, data)?;
        let places = || Places::new(entries(object, from.subindex, count));
        may_write(entries(object, from.subindex, count), state)?;
        let length = places().bytes();
        if length != data.len() {
            return Err(WrongLength { expected: length, found: data.len() }.into());
        }
        self.judge_whole(from, data)?;
        let writable = || places().filter(|(entry, _)| entry.access.check_write(state).is_ok());
        for (entry, place) in writable() {
            let to = Address::new(from.index, entry.subindex);
            check(
                &self.values,
                found(&self.values, to)?,
                to,
                piece(data, entry, place, &mut Scratch::default()),
            )?;
        }
        let is_count = |(entry, _): &(&EntryInfo, usize)| entry.subindex == 0;
        for (entry, place) in writable().filter(|it| !is_count(it)).chain(writable().filter(is_count)) {
            let to = Address::new(from.index, entry.subindex);
            self.write(found(&self.values, to)?, to, piece(data, entry, place, &mut Scratch::default()))?;
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
        let found = found(&self.values, Address::new(index, 0))?;
        let mut scratch = Scratch::default();
        Ok(self.value(found, &mut scratch)?.first().copied().unwrap_or(0))
    }
}

/// The object, if it can be transferred as a whole. Those who call this ask once more whether the device does that at
/// all: so the compiler leaves out what comes after, where it does not.
fn whole(values: &impl Values, from: Address) -> Result<&'static ObjectInfo, AbortCode> {
    let object = values.table().object(from.index).ok_or(AbortCode::NO_SUCH_OBJECT)?;
    if from.subindex > 1 {
        return Err(AbortCode::NO_SUCH_SUBINDEX);
    }
    if !values.has_complete_access() || object.code == ObjectCode::Variable {
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
