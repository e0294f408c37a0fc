//! Process data of the C-887: packing loses nothing, and lays out what the manual lists.

use devc_generated::c887::*;
use devc_runtime::bytes::ByteArray;
use devc_runtime::object::Address;
use devc_runtime::pdo::{Mapping, Pdo, ProcessData};
use devc_tests::manual::c887::{Assigned, Mapped};
use devc_tests::manual::{Direction, rows};

/// Images that follow no pattern, the same in each run; the first are all zeros and all ones.
fn images<T: ByteArray>(zero: T) -> impl Iterator<Item = T> {
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    (0..2000).map(move |number| {
        let mut image = zero;
        for byte in image.as_mut() {
            // xorshift by Marsaglia
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            *byte = match number {
                0 => 0x00,
                1 => 0xFF,
                _ => state.to_be_bytes()[0],
            };
        }
        image
    })
}

/// Both ways for all of a PDO; every value of the struct comes out of some image, as its fields have all bits.
fn check_packing<T: ProcessData + PartialEq + std::fmt::Debug>(zero: T::Image)
where
    T::Image: PartialEq + std::fmt::Debug,
{
    for image in images(zero) {
        let value = T::unpack(image);
        assert_eq!(value.pack(), image);
        assert_eq!(T::unpack(value.pack()), value);
        let mut frame = vec![0xA5; T::LEN];
        assert_eq!(value.pack_into(&mut frame), Ok(()));
        assert_eq!(T::unpack_from(&frame), Ok(value));
        assert!(T::unpack_from(&frame[1..]).is_err());
    }
}

#[test]
fn packing_loses_nothing() {
    check_packing::<RxPdo1600>([0; 7]);
    check_packing::<RxPdo1601>([0; 15]);
    check_packing::<TxPdo1A00>([0; 11]);
    check_packing::<TxPdo1A01>([0; 7]);
    check_packing::<Outputs>([0; 42]);
    check_packing::<Inputs>([0; 66]);
}

/// What the manual maps to a PDO.
fn listed(direction: Direction, pdo: u16) -> Vec<Mapping> {
    let mapped = rows::<Mapped>().expect("the table is whole").into_iter();
    let of_pdo = mapped.filter(|row| row.direction == direction && row.pdo == pdo);
    of_pdo.map(|row| Mapping { address: Address::new(row.index, row.subindex), bits: row.bits }).collect()
}

fn check_mapping<T: Pdo>(
    direction: Direction,
    index: impl Fn(Axis) -> u16,
    mapping: impl Fn(Axis) -> Vec<Mapping>,
) {
    assert_eq!((index(Axis::X), mapping(Axis::X).as_slice()), (T::INDEX, T::MAPPING));
    for axis in Axis::ALL {
        let listed = listed(direction, index(axis));
        assert_eq!(mapping(axis), listed, "0x{:04X}", index(axis));
        let bits: usize = listed.iter().map(|mapping| usize::from(mapping.bits)).sum();
        assert_eq!(T::LEN * 8, bits);
    }
}

#[test]
fn mappings_are_those_of_the_manual() {
    use Direction::{Rx, Tx};
    check_mapping::<RxPdo1600>(Rx, RxPdo1600::index, |axis| RxPdo1600::mapping(axis).to_vec());
    check_mapping::<RxPdo1601>(Rx, RxPdo1601::index, |axis| RxPdo1601::mapping(axis).to_vec());
    check_mapping::<TxPdo1A00>(Tx, TxPdo1A00::index, |axis| TxPdo1A00::mapping(axis).to_vec());
    check_mapping::<TxPdo1A01>(Tx, TxPdo1A01::index, |axis| TxPdo1A01::mapping(axis).to_vec());
    let pdos: std::collections::BTreeSet<u16> =
        rows::<Mapped>().expect("the table is whole").iter().map(|row| row.pdo).collect();
    assert_eq!(pdos.len(), 4 * Axis::ALL.len());
}

#[test]
fn fields_lie_in_the_order_of_the_mapping() {
    let pdo =
        RxPdo1600 { controlword: Controlword(0x0201), modes_of_operation: 3, target_position: 0x0706_0504 };
    assert_eq!(pdo.pack(), [1, 2, 3, 4, 5, 6, 7]);
    let pdo = TxPdo1A00 {
        statusword: Statusword(0x0201),
        modes_of_operation_display: 3,
        position_actual_value: 0x0706_0504,
        following_error_actual_value: -1,
    };
    assert_eq!(pdo.pack(), [1, 2, 3, 4, 5, 6, 7, 0xFF, 0xFF, 0xFF, 0xFF]);
}

#[test]
fn the_default_images_are_the_assigned_pdos_in_a_row() {
    let assigned = rows::<Assigned>().expect("the table is whole");
    let bytes = |direction| -> usize {
        assigned.iter().filter(|row| row.direction == direction).map(|row| usize::from(row.bytes)).sum()
    };
    assert_eq!((Outputs::LEN, Inputs::LEN), (bytes(Direction::Rx), bytes(Direction::Tx)));
    let mut outputs = Outputs::unpack([0; 42]);
    outputs.axes[5].target_position = -1;
    assert_eq!(outputs.pack()[38..], [0xFF; 4]);
    let outputs = assigned.iter().filter(|row| row.direction == Direction::Rx).filter_map(|row| row.pdo);
    assert!(outputs.eq(Axis::ALL.map(RxPdo1600::index)));
}
