//! Fields in place against arithmetic on the image as one large number.

use devc_runtime::object::Value;
use devc_runtime::pdo::InPlace;
use devc_runtime::pdo::place::{load, part, part_mut, row, row_mut, store};

use crate::c887::{Controlword, RxPdo1600, RxPdo1600View};
use crate::numbers::Numbers;

/// Bytes of the images here, those of the number that they are compared with.
const LENGTH: usize = 16;

/// The bits of a number from `offset` on.
fn bits_of(number: u128, offset: usize, bits: usize) -> u128 {
    number >> offset & mask(bits)
}

fn mask(bits: usize) -> u128 {
    (1 << bits) - 1
}

/// A value as a number of so many bits: the encoding with zeros or copies of the sign above it.
fn number<T: Value>(value: T, bits: usize, is_signed: bool) -> u128 {
    let bytes = value.to_bytes();
    let bytes = bytes.as_ref();
    let is_negative = is_signed && bytes.last().is_some_and(|byte| byte & 0x80 != 0);
    let filled: [u8; 16] =
        core::array::from_fn(|n| bytes.get(n).copied().unwrap_or(if is_negative { 0xFF } else { 0 }));
    u128::from_le_bytes(filled) & mask(bits)
}

/// Loads and stores random values at a place in random images.
fn check<T: Value + PartialEq + core::fmt::Debug, const OFFSET: usize, const BITS: usize>(
    numbers: &mut Numbers,
    is_signed: bool,
) where
    T::Bytes: Default,
{
    for _ in 0..200 {
        let image: [u8; LENGTH] = numbers.bytes();
        let before = u128::from_le_bytes(image);

        let loaded = load::<T, OFFSET, BITS, LENGTH>(&image);
        let of_type = BITS.min(8 * T::SIZE);
        let expected = bits_of(before, OFFSET, of_type);
        assert_eq!(number(loaded, of_type, is_signed), expected, "{OFFSET} + {BITS} of {before:#x}");
        let is_negative = is_signed && expected >> (of_type - 1) & 1 != 0;
        let above = number(loaded, 8 * T::SIZE, is_signed) >> of_type;
        assert_eq!(above, if is_negative { mask(8 * T::SIZE - of_type) } else { 0 }, "{OFFSET} + {BITS}");

        let mut bytes = T::Bytes::default();
        bytes.as_mut().fill_with(|| numbers.next() as u8);
        let value = T::from_bytes(bytes);
        let mut stored = image;
        store::<T, OFFSET, BITS, LENGTH>(&mut stored, value);
        let expected = before & !(mask(BITS) << OFFSET) | number(value, BITS, is_signed) << OFFSET;
        assert_eq!(u128::from_le_bytes(stored), expected, "{OFFSET} + {BITS}: {value:?} into {before:#x}");
    }
}

macro_rules! check_at {
    ($numbers:ident: $($type:ty, $is_signed:literal, $bits:literal: $($offset:literal)+;)+) => {
        $($(check::<$type, $offset, $bits>(&mut $numbers, $is_signed);)+)+
    };
}

#[test]
fn fields_of_bits_are_where_the_number_has_them() {
    let mut numbers = Numbers::new();
    check_at! { numbers:
        bool, false, 1: 0 1 2 3 4 5 6 7 8 63 64 127;
        u8, false, 1: 0 7 8 127;
        u8, false, 3: 0 1 4 5 6 7 8 120 125;
        u8, false, 7: 0 1 2 3 121;
        u8, false, 8: 0 1 7 8 9 119 120;
        u8, false, 12: 0 3 4 7 116;
        i8, true, 4: 0 1 4 5 6 124;
        i8, true, 8: 0 3 120;
        i8, true, 16: 0 5 8 112;
        u16, false, 9: 0 1 6 7 8 119;
        u16, false, 16: 0 1 8 15 111 112;
        i16, true, 12: 0 4 6 116;
        i16, true, 32: 0 8 3 96;
        u32, false, 17: 0 7 14 111;
        u32, false, 24: 0 1 8 104;
        i32, true, 31: 0 1 97;
        i32, true, 32: 0 4 8 96;
        u64, false, 63: 0 1 65;
        i64, true, 64: 0 3 8 64;
        i64, true, 33: 0 7 95;
        [u8; 3], false, 24: 0 4 104;
        [u8; 9], false, 72: 0 8 5 56;
    }
}

#[test]
fn reals_keep_their_bits() {
    let mut image = [0xA5; 9];
    store::<f32, 3, 32, 9>(&mut image, -1.5);
    assert_eq!(load::<f32, 3, 32, 9>(&image), -1.5);
    store::<f64, 8, 64, 9>(&mut image, f64::MIN_POSITIVE);
    assert_eq!(image[1..], f64::MIN_POSITIVE.to_le_bytes());
}

#[test]
fn a_view_reads_and_writes_what_is_packed() {
    let mut numbers = Numbers::new();
    for _ in 0..1000 {
        let mut image: [u8; 7] = numbers.bytes();
        let value = RxPdo1600::unpack(image);
        let view = RxPdo1600View(&image);
        assert_eq!(
            (view.controlword(), view.modes_of_operation(), view.target_position()),
            (value.controlword, value.modes_of_operation, value.target_position)
        );
        let value = RxPdo1600::unpack(numbers.bytes());
        let mut view = RxPdo1600View(&mut image);
        view.set_controlword(value.controlword);
        view.set_modes_of_operation(value.modes_of_operation);
        view.set_target_position(value.target_position);
        assert_eq!(image, value.pack());
    }
}

#[test]
fn a_view_is_of_bytes_owned_or_borrowed_and_just_as_long() {
    let mut owned = RxPdo1600View([0; 7]);
    owned.set_controlword(Controlword(0x0201));
    assert_eq!(owned.0, [1, 2, 0, 0, 0, 0, 0]);
    for length in (0..20).filter(|length| *length != 7) {
        let mut frame = vec![0; length];
        let wrong = RxPdo1600::view_of(&frame).unwrap_err();
        assert_eq!((wrong.expected, wrong.found), (7, length));
        assert_eq!(RxPdo1600::view_of_mut(&mut frame).unwrap_err(), wrong);
    }
}

#[test]
fn parts_are_the_bytes_at_their_places() {
    let mut image: [u8; 9] = core::array::from_fn(|n| n as u8);
    assert_eq!(part::<[u8; 3], 2, 9>(&image), &[2, 3, 4]);
    assert_eq!(row::<3, 2, 3, 9>(&image), &[[3, 4, 5], [6, 7, 8]]);
    *part_mut::<[u8; 2], 7, 9>(&mut image) = [0; 2];
    row_mut::<2, 2, 1, 9>(&mut image)[1] = [9; 2];
    assert_eq!(image, [0, 1, 2, 9, 9, 5, 6, 0, 0]);
}
