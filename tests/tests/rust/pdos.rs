//! Process data of the C-887: packing loses nothing, and lays out what the manual lists.

use devc_generated::c887::*;
use devc_runtime::bytes::ByteArray;
use devc_runtime::object::Address;
use devc_runtime::pdo::{InPlace, Mapping, Pdo, ProcessData};
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

/// Each field in place is the field by value, and writing all of them writes the image.
macro_rules! check_view {
    ($pdo:ty, $zero:expr; $($get:ident $set:ident)+) => {
        for image in images($zero) {
            let value = <$pdo>::unpack(image);
            let view = <$pdo>::view(&image);
            $(assert_eq!(view.$get(), value.$get);)+
            let mut written = $zero;
            let mut view = <$pdo>::view(&mut written);
            $(view.$set(value.$get);)+
            assert_eq!(written, value.pack());
        }
    };
}

#[test]
fn fields_in_place_are_the_fields_by_value() {
    check_view!(RxPdo1600, [0; 7];
        controlword set_controlword
        modes_of_operation set_modes_of_operation
        target_position set_target_position);
    check_view!(TxPdo1A00, [0; 11];
        statusword set_statusword
        modes_of_operation_display set_modes_of_operation_display
        position_actual_value set_position_actual_value
        following_error_actual_value set_following_error_actual_value);
    use devc_generated::s700::s700::TxPdo1B0B;
    check_view!(TxPdo1B0B, [0; 40];
        position_actual_value_1 set_position_actual_value_1
        position_actual_value_2 set_position_actual_value_2
        velocity_actual_value set_velocity_actual_value
        current_actual_value set_current_actual_value
        statusword set_statusword
        drive_errors set_drive_errors
        drive_warnings set_drive_warnings
        digital_io set_digital_io
        analog_inputs_analog_input_1 set_analog_inputs_analog_input_1
        analog_inputs_analog_input_2 set_analog_inputs_analog_input_2
        internal_following_error set_internal_following_error
        motion_task_status set_motion_task_status);
}

#[test]
fn a_view_of_an_image_has_a_view_of_each_axis() {
    for image in images([0; 42]) {
        let value = Outputs::unpack(image);
        for (view, pdo) in OutputsView(&image).axes().into_iter().zip(value.axes) {
            assert_eq!(view.target_position(), pdo.target_position);
        }
        let mut written = [0; 42];
        for (view, pdo) in OutputsView(&mut written).axes_mut().into_iter().zip(value.axes) {
            *view.0 = pdo.pack();
        }
        assert_eq!(written, image);
    }
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
