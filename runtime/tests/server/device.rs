//! A dictionary with an entry for each thing that can be asked of one.

use devc_runtime::object::Address;
use devc_runtime::sdo::{
    Access, DataType, Dictionary, EntryInfo, Limits, NONE, ObjectCode, ObjectInfo, Page, Place, Range, Slot,
    Values,
};

pub(crate) const NAME: Address = Address::new(0x2000, 0);
pub(crate) const GAIN: Address = Address::new(0x2001, 0);
pub(crate) const SECRET: Address = Address::new(0x2002, 0);
pub(crate) const NOTE: Address = Address::new(0x2003, 0);
pub(crate) const MODEL: Address = Address::new(0x2004, 0);
pub(crate) const FLAGS: Address = Address::new(0x2005, 0);
pub(crate) const WIDE: Address = Address::new(0x2006, 0);
pub(crate) const RATIO: Address = Address::new(0x2007, 0);
pub(crate) const LIST: u16 = 0x2010;
pub(crate) const MIXED: u16 = 0x2011;
pub(crate) const NARROW: u16 = 0x2012;
pub(crate) const APART: u16 = 0x2013;

/// The values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Tiny {
    pub(crate) name: &'static str,
    pub(crate) gain: i16,
    pub(crate) secret: u32,
    pub(crate) note: [u8; 8],
    pub(crate) flags: u8,
    pub(crate) wide: [u8; 3],
    pub(crate) ratio: f32,
    pub(crate) count: u8,
    pub(crate) list: [u16; 3],
    pub(crate) mixed: (i32, u16),
    pub(crate) narrow: (bool, u8, u8, u16),
}

impl Tiny {
    pub(crate) const NEW: Self = Self {
        name: "tiny",
        gain: 5,
        secret: 0,
        note: *b"hi\0\0\0\0\0\0",
        flags: 0,
        wide: [1, 2, 3],
        ratio: 1.5,
        count: 2,
        list: [0x0101, 0x0202, 0x0303],
        mixed: (-1, 7),
        narrow: (true, 0b101, 0b11_0011, 0x1234),
    };
}

impl Values for Tiny {
    fn table(&self) -> &'static Dictionary {
        &TABLE
    }

    fn ranges(&self) -> &'static [Range] {
        const {
            &[
                range(1, Limits::Signed(-10, 1000)),
                range(5, Limits::Unsigned(1, 0x80_0000)),
                range(6, Limits::Real(0.5, 2.0)),
            ]
        }
    }

    fn has_complete_access(&self) -> bool {
        true
    }

    fn slot(&mut self, place: Place) -> Option<Slot<'_>> {
        match (place.field, place.item) {
            (0, _) => Some(Slot::Text(self.name)),
            (1, _) => Some(Slot::I16(&mut self.gain)),
            (2, _) => Some(Slot::U32(&mut self.secret)),
            (3, _) => Some(Slot::Bytes(&mut self.note)),
            (4, _) => Some(Slot::U8(&mut self.flags)),
            (5, _) => Some(Slot::Bytes(&mut self.wide)),
            (6, _) => Some(Slot::F32(&mut self.ratio)),
            (7, 0) => Some(Slot::U8(&mut self.count)),
            (7, item) => self.list.get_mut(usize::from(item) - 1).map(Slot::U16),
            (8, 0) => Some(Slot::I32(&mut self.mixed.0)),
            (8, 1) => Some(Slot::U16(&mut self.mixed.1)),
            (9, 0) => Some(Slot::Bool(&mut self.narrow.0)),
            (9, 1) => Some(Slot::U8(&mut self.narrow.1)),
            (9, 2) => Some(Slot::U8(&mut self.narrow.2)),
            (9, 3) => Some(Slot::U16(&mut self.narrow.3)),
            _ => None,
        }
    }
}

const fn range(field: u16, limits: Limits) -> Range {
    Range { place: Place { field, item: 0, axis: Range::EVERY_AXIS }, limits }
}

const fn entry(subindex: u8, item: u8, data_type: DataType, bits: u16, access: Access) -> EntryInfo {
    EntryInfo { subindex, item, data_type, bits, access }
}

const fn variable(field: u16, entries: &'static [EntryInfo]) -> ObjectInfo {
    ObjectInfo { code: ObjectCode::Variable, axis: 0, field, entries, constants: 3 }
}

const READ_WRITE: Access = Access::READ.and(Access::WRITE);
const BEFORE_SAFE: Access = Access::READ.and(Access::WRITE_PRE_OPERATIONAL);
const CONSTANT: u8 = EntryInfo::CONSTANT;

static TABLE: Dictionary = Dictionary {
    constants: b"\x04\x34\x12model 1",
    directory: &{
        let mut pages = [NONE; 256];
        pages[0x20] = 0;
        pages
    },
    pages: &[Page {
        first: 0,
        axis: 0,
        slots: &[0, 1, 2, 3, 4, 5, 6, 7, NONE, NONE, NONE, NONE, NONE, NONE, NONE, NONE, 8, 9, 10, 11],
        objects: &[
            variable(0, &[entry(0, 0, DataType::VISIBLE_STRING, 80, Access::READ)]),
            variable(1, &[entry(0, 0, DataType::INTEGER16, 16, BEFORE_SAFE)]),
            variable(2, &[entry(0, 0, DataType::UNSIGNED32, 32, Access::WRITE)]),
            variable(3, &[entry(0, 0, DataType::VISIBLE_STRING, 64, READ_WRITE)]),
            variable(0, &[entry(0, CONSTANT, DataType::VISIBLE_STRING, 56, Access::READ)]),
            // BIT3
            variable(4, &[entry(0, 0, DataType(0x32), 3, READ_WRITE)]),
            variable(5, &[entry(0, 0, DataType::UNSIGNED24, 24, READ_WRITE)]),
            variable(6, &[entry(0, 0, DataType::REAL32, 32, READ_WRITE)]),
            ObjectInfo {
                code: ObjectCode::Array,
                axis: 0,
                field: 7,
                entries: &[
                    entry(0, 0, DataType::UNSIGNED8, 8, BEFORE_SAFE),
                    entry(1, 1, DataType::UNSIGNED16, 16, BEFORE_SAFE),
                    entry(2, 2, DataType::UNSIGNED16, 16, BEFORE_SAFE),
                    entry(3, 3, DataType::UNSIGNED16, 16, BEFORE_SAFE),
                ],
                constants: 0,
            },
            // a gap at 3, a constant in the middle
            ObjectInfo {
                code: ObjectCode::Record,
                axis: 0,
                field: 8,
                entries: &[
                    entry(0, CONSTANT, DataType::UNSIGNED8, 8, Access::READ),
                    entry(1, 0, DataType::INTEGER32, 32, READ_WRITE),
                    entry(2, CONSTANT, DataType::UNSIGNED16, 16, Access::READ),
                    entry(4, 1, DataType::UNSIGNED16, 16, Access::WRITE),
                ],
                constants: 0,
            },
            // BOOLEAN, BIT3 and BIT6 side by side, the last across the end of a byte
            ObjectInfo {
                code: ObjectCode::Record,
                axis: 0,
                field: 9,
                entries: &[
                    entry(0, CONSTANT, DataType::UNSIGNED8, 8, Access::READ),
                    entry(1, 0, DataType::BOOLEAN, 1, READ_WRITE),
                    entry(2, 1, DataType(0x32), 3, READ_WRITE),
                    entry(3, 2, DataType(0x35), 6, READ_WRITE),
                    entry(4, 3, DataType::UNSIGNED16, 16, READ_WRITE),
                ],
                constants: 0,
            },
            // the same values with a whole byte behind the bit
            ObjectInfo {
                code: ObjectCode::Record,
                axis: 0,
                field: 9,
                entries: &[
                    entry(0, CONSTANT, DataType::UNSIGNED8, 8, Access::READ),
                    entry(1, 0, DataType::BOOLEAN, 1, READ_WRITE),
                    entry(2, 1, DataType::UNSIGNED8, 8, READ_WRITE),
                    entry(3, 2, DataType(0x35), 6, READ_WRITE),
                    entry(4, 3, DataType::UNSIGNED16, 16, READ_WRITE),
                ],
                constants: 0,
            },
        ],
    }],
};
