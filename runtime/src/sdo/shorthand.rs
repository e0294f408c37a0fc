//! What generated tables are written with, so that an object is a line.
//!
//! ```
//! use devc_runtime::sdo::ObjectInfo;
//! use devc_runtime::sdo::shorthand::{ARRAY, I32, RO, RW, U32, VAR, entry, list, object};
//!
//! const OBJECTS: &[ObjectInfo] = &[
//!     object(VAR, 0, 0, 0, &[entry(0, 0, U32, 32, RO)]),
//!     object(ARRAY, 0, 1, 0, &list::<3>(0, I32, 32, RW)),
//! ];
//! assert_eq!(OBJECTS[1].highest_subindex(), 2);
//! ```

use super::{Access, DataType, EntryInfo, ObjectCode, ObjectInfo};

/// A single value.
pub const VAR: ObjectCode = ObjectCode::Variable;
/// Entries of one type.
pub const ARRAY: ObjectCode = ObjectCode::Array;
/// Entries of different types.
pub const RECORD: ObjectCode = ObjectCode::Record;

macro_rules! types {
    ($($short:ident = $name:ident;)+) => {
        $(
            #[doc = concat!("[`DataType::", stringify!($name), "`]")]
            pub const $short: DataType = DataType::$name;
        )+
    };
}
types! {
    BOOL = BOOLEAN;
    I8 = INTEGER8;
    I16 = INTEGER16;
    I32 = INTEGER32;
    I64 = INTEGER64;
    U8 = UNSIGNED8;
    U16 = UNSIGNED16;
    U32 = UNSIGNED32;
    U64 = UNSIGNED64;
    F32 = REAL32;
    F64 = REAL64;
    TEXT = VISIBLE_STRING;
}

/// A value that never changes.
pub const CONSTANT: u8 = EntryInfo::CONSTANT;
/// To be read.
pub const RO: Access = Access::READ;
/// To be written, in all states.
pub const WO: Access = Access::WRITE;
/// To be read and written.
pub const RW: Access = RO.and(WO);
/// To be written in Pre-Operational.
pub const PRE_OP: Access = Access::WRITE_PRE_OPERATIONAL;
/// To be written in Safe-Operational.
pub const SAFE_OP: Access = Access::WRITE_SAFE_OPERATIONAL;
/// To be written in Operational.
pub const OP: Access = Access::WRITE_OPERATIONAL;
/// In RxPDOs.
pub const RX: Access = Access::RX_PDO;
/// In TxPDOs.
pub const TX: Access = Access::TX_PDO;

/// An object with values that can change: their axis and field, the place of those that cannot, and all its entries.
pub const fn object(
    code: ObjectCode,
    axis: u8,
    field: u16,
    constants: u16,
    entries: &'static [EntryInfo],
) -> ObjectInfo {
    ObjectInfo { code, axis, field, entries, constants }
}

/// An object none of whose values can change: the place of the values, and its entries.
pub const fn constant(code: ObjectCode, constants: u16, entries: &'static [EntryInfo]) -> ObjectInfo {
    object(code, 0, 0, constants, entries)
}

/// An entry: the place of its value among those of the object that can change, its type, length and rights.
pub const fn entry(subindex: u8, item: u8, data_type: DataType, bits: u16, access: Access) -> EntryInfo {
    EntryInfo { subindex, item, data_type, bits, access }
}

/// The entries of an [`EntryInfo::list`].
pub const fn list<const N: usize>(
    item: u8,
    data_type: DataType,
    bits: u16,
    access: Access,
) -> [EntryInfo; N] {
    EntryInfo::list(item, data_type, bits, access)
}

/// The entries of an [`EntryInfo::counted`].
pub const fn counted<const N: usize>(data_type: DataType, bits: u16, access: Access) -> [EntryInfo; N] {
    EntryInfo::counted(data_type, bits, access)
}
