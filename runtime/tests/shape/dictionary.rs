//! The table against a plain list, and typed entries against the table.

use std::collections::BTreeMap;

use devc_runtime::object::{Address, Entry, Marker, Readable, Value, Writable};
use devc_runtime::sdo::CommunicationState::Operational;
use devc_runtime::sdo::{
    AbortCode, Access, DataType, Dictionary, EntryInfo, NONE, ObjectCode, ObjectInfo, Page, Place, Values,
    positions,
};
use devc_runtime::unit::Measurand;

use crate::c887::dictionary::Dictionary as C887Values;
use crate::c887::{Axis, C887, Controlword, objects};

/// Index, number of entries, field, axis.
const OBJECTS: [(u16, u8, u16, u8); 5] =
    [(0x1008, 1, 0, 0), (0x6040, 1, 1, 0), (0x607D, 3, 2, 0), (0x6840, 1, 1, 1), (0x687D, 3, 2, 1)];

/// The objects of an axis, the same for each.
static AXIS: [ObjectInfo; 2] = [
    ObjectInfo { code: ObjectCode::Variable, axis: 0, field: 1, entries: &[byte(0, 0)], constants: 0 },
    ObjectInfo {
        code: ObjectCode::Record,
        axis: 0,
        field: 2,
        entries: &[byte(0, EntryInfo::CONSTANT), byte(1, 0), byte(2, 1)],
        constants: 0,
    },
];

/// Where they are, from 0x..40 on.
static SLOTS: [u8; 62] = positions(0x40, &[0x40, 0x7D]);

/// Two axes that share their tables, and an object of the device.
static TWO_AXES: Dictionary = Dictionary {
    constants: &[2],
    directory: &{
        let mut pages = [NONE; 256];
        (pages[0x10], pages[0x60], pages[0x68]) = (0, 1, 2);
        pages
    },
    pages: &[
        Page {
            first: 0x08,
            axis: 0,
            slots: &[0],
            objects: &[ObjectInfo {
                code: ObjectCode::Variable,
                axis: 0,
                field: 0,
                entries: &[byte(0, 0)],
                constants: 0,
            }],
        },
        Page { first: 0x40, axis: 0, slots: &SLOTS, objects: &AXIS },
        Page { first: 0x40, axis: 1, slots: &SLOTS, objects: &AXIS },
    ],
};

const fn byte(subindex: u8, item: u8) -> EntryInfo {
    EntryInfo { subindex, item, data_type: DataType::UNSIGNED8, bits: 8, access: Access::READ }
}

/// The number of entries at subindex 0 of a record never changes.
fn places((index, count, field, axis): (u16, u8, u16, u8)) -> Vec<(Address, Option<Place>)> {
    let item = |subindex: u8| if count == 1 { Some(0) } else { subindex.checked_sub(1) };
    let place = |subindex| item(subindex).map(|item| Place { field, item, axis });
    (0..count).map(|subindex| (Address::new(index, subindex), place(subindex))).collect()
}

#[test]
fn every_address_is_found_or_told_missing() {
    let expected: BTreeMap<Address, Option<Place>> = OBJECTS.into_iter().flat_map(places).collect();
    for index in 0..=u16::MAX {
        for subindex in [0, 1, 2, 3, 4, 127, 255] {
            let address = Address::new(index, subindex);
            let found = TWO_AXES.find(address).map(|found| found.place());
            let missing = match OBJECTS.iter().any(|(of, ..)| *of == index) {
                true => AbortCode::NO_SUCH_SUBINDEX,
                false => AbortCode::NO_SUCH_OBJECT,
            };
            assert_eq!(found, expected.get(&address).copied().ok_or(missing), "{address}");
        }
    }
    let count = TWO_AXES.find(Address::new(0x687D, 0)).unwrap();
    assert_eq!(TWO_AXES.constant(count), Some([2].as_slice()));
}

#[test]
fn objects_are_listed_ascending() {
    let listed: Vec<u16> = TWO_AXES.objects().map(|(index, _)| index).collect();
    assert_eq!(listed, OBJECTS.map(|(index, ..)| index));
}

#[test]
fn subindices_may_have_gaps() {
    static DICTIONARY: Dictionary = Dictionary {
        constants: &[],
        directory: &[0; 256],
        pages: &[Page {
            first: 0,
            axis: 0,
            slots: &[0],
            objects: &[ObjectInfo {
                code: ObjectCode::Record,
                axis: 0,
                field: 0,
                entries: &[byte(0, 0), byte(1, 1), byte(4, 4), byte(254, 254)],
                constants: 0,
            }],
        }],
    };
    let found = |subindex| DICTIONARY.find(Address::new(0x2000, subindex)).map(|found| found.entry.subindex);
    for subindex in 0..=u8::MAX {
        let expected = [0, 1, 4, 254].into_iter().find(|of| *of == subindex);
        assert_eq!(found(subindex), expected.ok_or(AbortCode::NO_SUCH_SUBINDEX));
    }
}

#[test]
fn tables_that_point_nowhere_hold_no_objects() {
    static DICTIONARY: Dictionary = Dictionary {
        constants: &[],
        directory: &[1; 256],
        pages: &[
            Page { first: 0, axis: 0, slots: &[], objects: &[] },
            Page { first: 9, axis: 0, slots: &[200; 10], objects: &[] },
        ],
    };
    assert_eq!(DICTIONARY.objects().count(), 0);
    assert_eq!(DICTIONARY.find(Address::new(0x2009, 0)), Err(AbortCode::NO_SUCH_OBJECT));
}

/// What the types of an entry say, and what the table says.
fn same<T: Value, A: Marker, M, Q: Measurand>(entry: Entry<C887, T, A, M, Q>) {
    let (access, size) = (entry.access(), T::SIZE);
    let rights = |of: Access| [of.check_read(Operational), of.check_write(Operational)];
    let found = C887Values::DEFAULT.table().find(entry.address()).map(|found| found.entry);
    let found = found.map(|info| (info.data_type, usize::from(info.bytes()), rights(info.access)));
    assert_eq!(found, Ok((T::DATA_TYPE, size, rights(access))), "{}", entry.address());
}

#[test]
fn types_and_table_agree() {
    for axis in Axis::ALL {
        same(objects::controlword(axis));
        same(objects::statusword(axis));
        same(objects::modes_of_operation(axis));
        same(objects::modes_of_operation_display(axis));
        same(objects::position_actual_value(axis));
        same(objects::target_position(axis));
        same(objects::software_position_limit::min_position_limit(axis));
        same(objects::software_position_limit::max_position_limit(axis));
    }
    let name = C887Values::DEFAULT.table().find(objects::MANUFACTURER_DEVICE_NAME.address()).unwrap().entry;
    assert_eq!((name.data_type, name.bytes()), (DataType::VISIBLE_STRING, 14));
}

/// A device that keeps what it is sent: what a master's own SDO client looks like over typed entries.
#[derive(Default)]
struct Memory(BTreeMap<Address, Vec<u8>>);

impl Memory {
    fn write<T: Value, A: Writable, M, Q: Measurand>(&mut self, entry: Entry<C887, T, A, M, Q>, value: T) {
        self.0.insert(entry.address(), entry.encode(value).as_ref().to_vec());
    }

    fn read<T: Value, A: Readable, M, Q: Measurand>(
        &self,
        entry: Entry<C887, T, A, M, Q>,
    ) -> Result<T, AbortCode> {
        let data = self.0.get(&entry.address()).ok_or(AbortCode::NO_DATA)?;
        Ok(entry.decode(data)?)
    }
}

#[test]
fn a_master_reads_what_it_wrote() {
    let mut drive = Memory::default();
    drive.write(objects::controlword(Axis::Y), Controlword(0x000F));
    drive.write(objects::software_position_limit::min_position_limit(Axis::X), -1_000_000);
    assert_eq!(drive.read(objects::controlword(Axis::Y)), Ok(Controlword(0x000F)));
    assert_eq!(drive.read(objects::software_position_limit::min_position_limit(Axis::X)), Ok(-1_000_000));
    assert_eq!(drive.read(objects::controlword(Axis::X)), Err(AbortCode::NO_DATA));
    drive.0.insert(Address::new(0x6064, 0), vec![0; 8]);
    assert_eq!(drive.read(objects::position_actual_value(Axis::X)), Err(AbortCode::LENGTH_TOO_HIGH));
}

#[test]
fn a_text_ends_where_the_padding_starts() {
    assert_eq!(objects::MANUFACTURER_DEVICE_NAME.decode(b"C-887 EtherCAT"), Ok("C-887 EtherCAT"));
    assert_eq!(objects::MANUFACTURER_DEVICE_NAME.decode(b"C-887\0\0\0"), Ok("C-887"));
    assert_eq!(objects::MANUFACTURER_DEVICE_NAME.decode(b""), Ok(""));
    assert!(objects::MANUFACTURER_DEVICE_NAME.decode(b"\xFF").is_err());
}
