//! Process data against bytes laid out by the mapping.

use devc_runtime::cia402::Mode as _;
use devc_runtime::object::Address;
use devc_runtime::pdo::{Direction, Mapping, Pdo, ProcessData};

use crate::c887::{Controlword, ModeOfOperation, RxPdo1600, Statusword, TxPdo1A00};
use crate::numbers::Numbers;

/// Every image is a value and every value comes back, whatever the bits.
fn round_trip<P: ProcessData<Image = [u8; N]> + PartialEq + core::fmt::Debug, const N: usize>() {
    let mut numbers = Numbers::new();
    let single_bits =
        (0..8 * N).map(|bit| core::array::from_fn(|byte| u8::from(byte == bit / 8) << (bit % 8)));
    for image in single_bits.chain((0..10_000).map(|_| numbers.bytes())) {
        let value = P::unpack(image);
        assert_eq!(value.pack(), image);
        assert_eq!(P::unpack(value.pack()), value);
        assert_eq!(P::unpack_from(&image), Ok(value));
        let mut frame = [0xA5; N];
        assert_eq!(value.pack_into(&mut frame), Ok(()));
        assert_eq!(frame, image);
    }
}

#[test]
fn what_is_unpacked_is_what_was_packed() {
    round_trip::<RxPdo1600, 7>();
    round_trip::<TxPdo1A00, 11>();
}

#[test]
fn fields_are_where_the_mapping_says() {
    let mut numbers = Numbers::new();
    for _ in 0..1000 {
        let (word, mode, position, error) =
            (numbers.next() as u16, numbers.next() as i8, numbers.next() as i32, numbers.next() as i32);
        let head =
            |word: u16| [word.to_le_bytes().as_slice(), &[mode as u8], &position.to_le_bytes()].concat();
        let rx =
            RxPdo1600 { controlword: Controlword(word), modes_of_operation: mode, target_position: position };
        assert_eq!(rx.pack().as_slice(), head(word));
        let tx = TxPdo1A00 {
            statusword: Statusword(word),
            modes_of_operation_display: mode,
            position_actual_value: position,
            following_error_actual_value: error,
        };
        assert_eq!(tx.pack().as_slice(), [head(word).as_slice(), &error.to_le_bytes()].concat());
    }
}

fn bits_of<P: Pdo>() -> usize {
    P::MAPPING.iter().map(|mapping| usize::from(mapping.bits)).sum()
}

#[test]
fn lengths_are_the_sums_of_the_mapped_bits() {
    assert_eq!((RxPdo1600::LEN, TxPdo1A00::LEN), (7, 11));
    assert_eq!((bits_of::<RxPdo1600>(), bits_of::<TxPdo1A00>()), (8 * 7, 8 * 11));
    assert_eq!(<RxPdo1600 as ProcessData>::Direction::ASSIGNMENT, 0x1C12);
    assert_eq!(<TxPdo1A00 as ProcessData>::Direction::ASSIGNMENT, 0x1C13);
}

#[test]
fn a_mapping_is_the_number_that_its_object_holds() {
    let words: Vec<u32> = RxPdo1600::MAPPING.iter().map(|mapping| mapping.word()).collect();
    assert_eq!(words, [0x6040_0010, 0x6060_0008, 0x607A_0020]);
    let gap = Mapping { address: Address::new(0, 0), bits: 8 };
    assert_eq!(Mapping::from_word(gap.word()), gap);
}

#[test]
fn a_frame_of_another_length_is_left_alone() {
    let rx = RxPdo1600::unpack([0xFF; 7]);
    for length in (0..20).filter(|length| *length != 7) {
        let mut frame = vec![0; length];
        let wrong = rx.pack_into(&mut frame).unwrap_err();
        assert_eq!((wrong.expected, wrong.found), (7, length));
        assert_eq!(RxPdo1600::unpack_from(&frame), Err(wrong));
        assert!(frame.iter().all(|byte| *byte == 0));
    }
}

#[test]
fn the_mode_that_is_displayed_is_one_of_the_device_or_stays_a_number() {
    let known: Vec<_> = (i8::MIN..=i8::MAX).filter_map(|code| ModeOfOperation::decode(code).ok()).collect();
    use ModeOfOperation::*;
    assert_eq!(known, [NoMode, Hm, Csp]);
    assert_eq!(ModeOfOperation::decode(-1).unwrap_err().to_string(), "unknown mode of operation -1");
}
