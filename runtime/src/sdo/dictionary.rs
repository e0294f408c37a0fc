//! The table that answers for an address.
//!
//! Two steps lead to an object, however many there are: the high byte of the index names a page, and the low byte a
//! slot of it. Tables are constant data that devc lays out. They name each other by position, and a position that
//! does not exist is an object that does not exist, so that no lookup can fail in another way.

use super::{AbortCode, Access, DataType};
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
}

/// The objects whose indices share the high byte.
///
/// Nothing in it depends on that byte but `ordinal`, so that the pages of axes that are alike share their tables.
#[derive(Debug, Clone, Copy)]
pub struct Page {
    /// The low byte of the first index.
    pub first: u8,
    /// From `first` on, for each low byte the position in `objects` of its object, else [`NONE`].
    pub slots: &'static [u8],
    /// The objects, ascending by index.
    pub objects: &'static [ObjectInfo],
    /// How many entries the pages before this one have.
    pub ordinal: u16,
}

/// What there is to know about an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ObjectInfo {
    /// What kind of object it is.
    pub code: ObjectCode,
    /// Its entries, ascending by subindex.
    pub entries: &'static [EntryInfo],
    /// How many entries the objects before it on its page have.
    pub ordinal: u16,
}

/// The kinds of objects (CiA 301, object code).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum ObjectCode {
    /// A single value.
    Variable = 0x07,
    /// Entries of one type.
    Array = 0x08,
    /// Entries of different types.
    Record = 0x09,
}

/// What there is to know about an entry (ETG.1000.6, get entry description).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EntryInfo {
    /// Its subindex.
    pub subindex: u8,
    /// Its type.
    pub data_type: DataType,
    /// Its length, for strings the longest, in bits.
    pub bits: u16,
    /// What may be done with it.
    pub access: Access,
}

impl EntryInfo {
    /// The `N` entries of an object that has at subindex 0 their number, which cannot be written, and from subindex
    /// 1 on entries that are all alike. For tables, which are made when the code is compiled.
    ///
    /// ```
    /// use devc_runtime::sdo::{Access, DataType, EntryInfo};
    ///
    /// const ENTRIES: [EntryInfo; 3] = EntryInfo::list(DataType::INTEGER32, 32, Access::READ);
    /// assert_eq!((ENTRIES[0].bits, ENTRIES[2].subindex, ENTRIES[2].bits), (8, 2, 32));
    /// ```
    pub const fn list<const N: usize>(data_type: DataType, bits: u16, access: Access) -> [Self; N] {
        let mut list =
            [Self { subindex: 0, data_type: DataType::UNSIGNED8, bits: 8, access: Access::READ }; N];
        let mut subindex = 0;
        let mut rest: &mut [Self] = &mut list;
        while let [entry, tail @ ..] = rest {
            if subindex > 0 {
                *entry = Self { subindex, data_type, bits, access };
            }
            subindex = subindex.wrapping_add(1);
            rest = tail;
        }
        list
    }

    /// The length in an SDO, where bits are filled up to bytes.
    pub const fn bytes(self) -> u16 {
        self.bits.div_ceil(8)
    }
}

/// An entry that was looked up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Found {
    /// The object that it belongs to.
    pub object: &'static ObjectInfo,
    /// The entry.
    pub entry: &'static EntryInfo,
    /// Its number among all entries of the device, ascending by address from 0: the place of its value.
    pub ordinal: u16,
}

impl Dictionary {
    /// Finds an object.
    #[inline]
    pub fn object(&self, index: u16) -> Option<&'static ObjectInfo> {
        self.page_and_object(index).map(|(_, object)| object)
    }

    /// Finds an entry; if there is none, the abort code tells whether the object or the subindex is missing.
    #[inline]
    pub fn find(&self, address: Address) -> Result<Found, AbortCode> {
        let (page, object) = self.page_and_object(address.index).ok_or(AbortCode::NO_SUCH_OBJECT)?;
        let (position, entry) = object.entry(address.subindex).ok_or(AbortCode::NO_SUCH_SUBINDEX)?;
        let ordinal = page.ordinal.wrapping_add(object.ordinal).wrapping_add(position);
        Ok(Found { object, entry, ordinal })
    }

    /// Every object with its index, ascending (ETG.1000.6, get object dictionary list).
    pub fn objects(&self) -> impl Iterator<Item = (u16, &'static ObjectInfo)> {
        let pages = (0..=u8::MAX).filter_map(|high| self.page(high).map(|page| (high, page)));
        pages.flat_map(|(high, page)| {
            let index = move |low| u16::from_be_bytes([high, low]);
            (0..=u8::MAX).filter_map(move |low| page.object(low).map(|object| (index(low), object)))
        })
    }

    #[inline]
    fn page_and_object(&self, index: u16) -> Option<(&'static Page, &'static ObjectInfo)> {
        let [high, low] = index.to_be_bytes();
        let page = self.page(high)?;
        Some((page, page.object(low)?))
    }

    #[inline]
    fn page(&self, high: u8) -> Option<&'static Page> {
        let position = self.directory.get(usize::from(high))?;
        self.pages.get(usize::from(*position))
    }
}

impl Page {
    #[inline]
    fn object(&self, low: u8) -> Option<&'static ObjectInfo> {
        let offset = low.checked_sub(self.first)?;
        let position = self.slots.get(usize::from(offset))?;
        self.objects.get(usize::from(*position))
    }
}

impl ObjectInfo {
    /// Finds an entry and its position: at once where no subindex before it is missing, else by halving.
    #[inline]
    fn entry(&self, subindex: u8) -> Option<(u16, &'static EntryInfo)> {
        match self.entries.get(usize::from(subindex)) {
            Some(entry) if entry.subindex == subindex => Some((u16::from(subindex), entry)),
            _ => {
                let position = self.entries.binary_search_by_key(&subindex, |entry| entry.subindex).ok()?;
                Some((u16::try_from(position).ok()?, self.entries.get(position)?))
            }
        }
    }
}
