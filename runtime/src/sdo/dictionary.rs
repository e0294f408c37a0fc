//! The table that answers for an address.
//!
//! Two steps lead to an object, however many there are: the high byte of the index names a page, and the low byte a
//! slot of it. Tables are constant data that devc lays out. They name each other by position, and a position that
//! does not exist is an object that does not exist, so that no lookup can fail in another way.

use super::{AbortCode, EntryInfo, ObjectInfo, Place};
use crate::object::Address;

/// Where the tables have nothing: a position behind the end. A table of 256 that reaches it has no gaps.
pub const NONE: u8 = u8::MAX;

/// A table of `N` places that has, for each of the bytes given, its position among them, and [`NONE`] elsewhere;
/// its first place is that of the byte `first`. For tables of a [`Dictionary`], which are made when the code is
/// compiled; bytes outside the table are left out.
///
/// ```
/// use devc_runtime::sdo::{NONE, positions};
///
/// const SLOTS: [u8; 4] = positions(0x3F, &[0x3F, 0x40, 0x42]);
/// assert_eq!(SLOTS, [0, 1, NONE, 2]);
/// ```
pub const fn positions<const N: usize>(first: u8, mut bytes: &[u8]) -> [u8; N] {
    let mut table = [NONE; N];
    let mut position = 0;
    while let [byte, rest @ ..] = bytes {
        let place = byte.wrapping_sub(first) as usize;
        if let Some((_, [slot, ..])) = table.split_at_mut_checked(place) {
            *slot = position;
        }
        position = position.wrapping_add(1);
        bytes = rest;
    }
    table
}

/// All objects of a device (CiA 301, object dictionary).
#[derive(Debug, Clone, Copy)]
pub struct Dictionary {
    /// For each high byte of an index, the position in `pages` of the page that has its objects, else [`NONE`].
    pub directory: &'static [u8; 256],
    /// The pages, ascending by index.
    pub pages: &'static [Page],
    /// The values that never change, as an SDO carries them. Objects name theirs by position.
    pub constants: &'static [u8],
}

/// The objects whose indices share the high byte.
///
/// Nothing in it depends on that byte but `axis`, so that the pages of axes that are alike share their tables.
#[derive(Debug, Clone, Copy)]
pub struct Page {
    /// The low byte of the first index.
    pub first: u8,
    /// The axis from which its objects count theirs.
    pub axis: u8,
    /// From `first` on, for each low byte the position in `objects` of its object, else [`NONE`].
    pub slots: &'static [u8],
    /// The objects, ascending by index.
    pub objects: &'static [ObjectInfo],
}

/// An entry that was looked up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Found {
    /// The object that it belongs to.
    pub object: &'static ObjectInfo,
    /// The entry.
    pub entry: &'static EntryInfo,
    /// The axis that the object belongs to, from 0; 0 for an object of the device.
    pub axis: u8,
}

impl Found {
    /// Where its value is kept, if it can change.
    pub const fn place(self) -> Option<Place> {
        if self.entry.is_constant() {
            return None;
        }
        Some(Place { field: self.object.field, item: self.entry.item, axis: self.axis })
    }
}

impl Dictionary {
    /// Finds an object.
    #[inline]
    pub fn object(&self, index: u16) -> Option<&'static ObjectInfo> {
        let [low, high] = index.to_le_bytes();
        self.page(high)?.object(low)
    }

    /// Finds an entry; if there is none, the abort code tells whether the object or the subindex is missing.
    ///
    /// It takes the same few steps however many objects there are, and is small enough to be inlined where code is
    /// built for size.
    #[inline(always)]
    pub fn find(&self, address: Address) -> Result<Found, AbortCode> {
        let [low, high] = address.index.to_le_bytes();
        let page = self.page(high).ok_or(AbortCode::NO_SUCH_OBJECT)?;
        let object = page.object(low).ok_or(AbortCode::NO_SUCH_OBJECT)?;
        let entry = object.entry(address.subindex).ok_or(AbortCode::NO_SUCH_SUBINDEX)?;
        Ok(Found { object, entry, axis: page.axis.wrapping_add(object.axis) })
    }

    /// The value of an entry of this dictionary as an SDO carries it, if it never changes.
    pub fn constant(&self, found: Found) -> Option<&'static [u8]> {
        found.entry.is_constant().then(|| found.object.constant(found.entry, self.constants))
    }

    /// Every object with its index, ascending (ETG.1000.6, get object dictionary list).
    pub fn objects(&self) -> impl Iterator<Item = (u16, &'static ObjectInfo)> + use<> {
        let table = *self;
        let pages = (0..=u8::MAX).filter_map(move |high| table.page(high).map(|page| (high, page)));
        pages.flat_map(|(high, page)| {
            let index = move |low| u16::from_be_bytes([high, low]);
            (0..=u8::MAX).filter_map(move |low| page.object(low).map(|object| (index(low), object)))
        })
    }

    /// The position of the page of an object, and of the object on it.
    pub(super) fn position(&self, index: u16) -> Option<(usize, usize)> {
        let [high, low] = index.to_be_bytes();
        let page = self.directory.get(usize::from(high))?;
        let slots = self.pages.get(usize::from(*page))?;
        let object = slots.slots.get(usize::from(low.wrapping_sub(slots.first)))?;
        Some(((*page).into(), (*object).into()))
    }

    #[inline(always)]
    fn page(&self, high: u8) -> Option<&'static Page> {
        let position = self.directory.get(usize::from(high))?;
        self.pages.get(usize::from(*position))
    }
}

impl Page {
    /// An index below the first wraps to a place behind the last.
    #[inline(always)]
    fn object(&self, low: u8) -> Option<&'static ObjectInfo> {
        let offset = low.wrapping_sub(self.first);
        let position = self.slots.get(usize::from(offset))?;
        self.objects.get(usize::from(*position))
    }
}
