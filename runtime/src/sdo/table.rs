//! What a dictionary says of its objects and entries.

use super::{Access, DataType};

/// What there is to know about an object.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ObjectInfo {
    /// What kind of object it is.
    pub code: ObjectCode,
    /// The axis it belongs to, counted from that of its page; 0 for an object of the device.
    pub axis: u8,
    /// The number of the field that has its values, see [`Place`](super::Place).
    pub field: u16,
    /// Its entries, ascending by subindex.
    pub entries: &'static [EntryInfo],
    /// Where the values of those of its entries that never change are in the dictionary's constants, one after another.
    pub constants: u16,
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
    /// The position of its value among those of the object that change, or [`EntryInfo::CONSTANT`].
    pub item: u8,
    /// Its type.
    pub data_type: DataType,
    /// Its length, for strings the longest, in bits.
    pub bits: u16,
    /// What may be done with it.
    pub access: Access,
}

impl EntryInfo {
    /// Stands for a position where a value never changes, and is with the object instead.
    pub const CONSTANT: u8 = u8::MAX;

    /// The `N` entries of an object that has at subindex 0 their number, which never changes, and from subindex 1 on
    /// entries that are all alike; the first of these has its value at `item`. For tables, which are made when the
    /// code is compiled.
    ///
    /// ```
    /// use devc_runtime::sdo::{Access, DataType, EntryInfo};
    ///
    /// const ENTRIES: [EntryInfo; 3] = EntryInfo::list(0, DataType::INTEGER32, 32, Access::READ);
    /// assert_eq!((ENTRIES[0].bits, ENTRIES[0].item), (8, EntryInfo::CONSTANT));
    /// assert_eq!((ENTRIES[2].subindex, ENTRIES[2].item, ENTRIES[2].bits), (2, 1, 32));
    /// ```
    pub const fn list<const N: usize>(item: u8, data_type: DataType, bits: u16, access: Access) -> [Self; N] {
        let next = Self { subindex: 1, item, data_type, bits, access };
        next.behind(Self { subindex: 0, item: Self::CONSTANT, ..Self::COUNT })
    }

    /// The `N` entries of an object whose number of entries in use can change: it is the first of its values, and those
    /// of the other entries, which are all alike, follow. The values are kept in a [`List`](super::List).
    ///
    /// ```
    /// use devc_runtime::sdo::{Access, DataType, EntryInfo};
    ///
    /// const ENTRIES: [EntryInfo; 3] = EntryInfo::counted(DataType::UNSIGNED16, 16, Access::READ.and(Access::WRITE));
    /// assert_eq!((ENTRIES[0].bits, ENTRIES[0].item, ENTRIES[0].access), (8, 0, ENTRIES[1].access));
    /// assert_eq!((ENTRIES[2].subindex, ENTRIES[2].item, ENTRIES[2].bits), (2, 2, 16));
    /// ```
    pub const fn counted<const N: usize>(data_type: DataType, bits: u16, access: Access) -> [Self; N] {
        let next = Self { subindex: 1, item: 1, data_type, bits, access };
        next.behind(Self { access, ..Self::COUNT })
    }

    /// The number of entries.
    const COUNT: Self =
        Self { subindex: 0, item: 0, data_type: DataType::UNSIGNED8, bits: 8, access: Access::READ };

    /// The number of entries with such entries behind it.
    const fn behind<const N: usize>(self, count: Self) -> [Self; N] {
        let (mut list, mut next) = ([count; N], self);
        let mut rest: &mut [Self] = &mut list;
        if let [_, tail @ ..] = rest {
            rest = tail;
        }
        while let [entry, tail @ ..] = rest {
            *entry = next;
            next.subindex = next.subindex.wrapping_add(1);
            next.item = if next.is_constant() { next.item } else { next.item.wrapping_add(1) };
            rest = tail;
        }
        list
    }

    /// The length in an SDO, where bits are filled up to bytes.
    pub const fn bytes(self) -> u16 {
        self.bits.div_ceil(8)
    }

    /// Whether its value never changes.
    pub const fn is_constant(self) -> bool {
        self.item == Self::CONSTANT
    }
}

impl ObjectInfo {
    /// Finds an entry: at once where no subindex before it is missing, else in as many steps as are missing.
    #[inline(always)]
    pub fn entry(&self, subindex: u8) -> Option<&'static EntryInfo> {
        match self.entries.get(usize::from(subindex)) {
            Some(entry) if entry.subindex == subindex => Some(entry),
            _ => behind_gap(self.entries, subindex),
        }
    }

    /// The highest subindex of an entry; 0 for a single value.
    pub fn highest_subindex(&self) -> u8 {
        self.entries.last().map_or(0, |entry| entry.subindex)
    }

    /// The value of an entry that never changes, among the constants of the dictionary.
    pub(super) fn constant(&self, entry: &EntryInfo, constants: &'static [u8]) -> &'static [u8] {
        let others = self.entries.iter().filter(|other| other.is_constant());
        let before = others.take_while(|other| other.subindex < entry.subindex);
        let offset =
            before.fold(usize::from(self.constants), |sum, other| sum.wrapping_add(other.bytes().into()));
        let from = constants.get(offset..).unwrap_or_default();
        from.get(..usize::from(entry.bytes())).unwrap_or(from)
    }
}

/// Finds an entry before which subindices are missing: they ascend, so it is before the position of its own number.
fn behind_gap(entries: &'static [EntryInfo], subindex: u8) -> Option<&'static EntryInfo> {
    let candidates = entries.get(..usize::from(subindex)).unwrap_or(entries);
    let entry = candidates.iter().rfind(|entry| entry.subindex <= subindex)?;
    (entry.subindex == subindex).then_some(entry)
}
