//! Values of a few bits, and of three, five, six and seven bytes: in PDOs by the device and by the user, and in SDOs.

#![allow(unreachable_pub)] // what derives `Device` has to be public

use devc_runtime::Device;
use devc_runtime::object::{Address, Bit3, Int24, Int40, Int48, Int56, Uint24, Uint40, Value};
use devc_runtime::pdo::{InPlace, Pdo, ProcessData};
use devc_runtime::sdo::{AbortCode, CommunicationState::PreOperational, DataType, Server};

use widths::dictionary::Dictionary;
use widths::{Gear, RxPdo1600, RxPdo1600View};

#[derive(Debug, Device)]
#[device(path = "tests/rust/widths")]
pub struct Widths;

/// What 0x1600 is, mapped by the user but for what is in no dictionary: that is a gap, too.
#[derive(Debug, Clone, Copy, PartialEq, Pdo)]
#[pdo(mapping = widths::FreeRxPdo1601)]
struct Own {
    ready: bool,
    level: Bit3,
    gear: Gear,
    #[pdo(gap = 2)]
    torque: Int24,
    #[pdo(gap = 3)]
    count: Uint24,
    #[pdo(widths::objects::signed::FIVE, gap = 5)]
    five: Int40,
    #[pdo(widths::objects::signed::SIX)]
    six: Int48,
    #[pdo(widths::objects::signed::SEVEN)]
    seven: Int56,
    #[pdo(widths::objects::unsigned::PART_1)]
    part: Uint40,
}

const PDO: RxPdo1600 = RxPdo1600 {
    ready: true,
    level: Bit3::of::<6>(),
    gear: Gear::SLOW,
    torque: Int24::of::<-70_000>(),
    unknown: Bit3::of::<0>(),
    count: Uint24::of::<0xFE_DCBA>(),
    signed_five: Int40::of::<-500_000_000_000>(),
    signed_six: Int48::of::<0x7654_3210_FEDC>(),
    signed_seven: Int56::MIN,
    unsigned_part_1: Uint40::MAX,
};

const OWN: Own = Own {
    ready: PDO.ready,
    level: PDO.level,
    gear: PDO.gear,
    torque: PDO.torque,
    count: PDO.count,
    five: PDO.signed_five,
    six: PDO.signed_six,
    seven: PDO.signed_seven,
    part: PDO.unsigned_part_1,
};

/// CiA 301, transfer syntax: each value behind the one before, from the lowest bit of the first byte on.
fn in_a_row(values: &[(i64, u32)]) -> Vec<u8> {
    let bits = values.iter().flat_map(|(value, bits)| (0..*bits).map(move |bit| value >> bit & 1 == 1));
    let bits: Vec<bool> = bits.collect();
    let byte = |bits: &[bool]| bits.iter().rev().fold(0, |high, bit| high << 1 | u8::from(*bit));
    bits.chunks(8).map(byte).collect()
}

fn frame() -> Vec<u8> {
    in_a_row(&[
        (1, 1),
        (6, 3),
        (2, 2),
        (0, 2),
        (-70_000, 24),
        (0, 3),
        (0xFE_DCBA, 24),
        (0, 5),
        (-500_000_000_000, 40),
        (0x7654_3210_FEDC, 48),
        (-(1 << 55), 56),
        ((1 << 40) - 1, 40),
    ])
}

#[test]
fn values_lie_at_their_bits() {
    assert_eq!(PDO.pack().as_slice(), frame());
    assert_eq!(RxPdo1600::unpack_from(&frame()), Ok(PDO));
    assert_eq!(OWN.pack().as_slice(), frame());
    assert_eq!(Own::unpack_from(&frame()), Ok(OWN));
}

#[test]
fn values_are_seen_and_set_in_place() {
    let mut image = [0; RxPdo1600::LEN];
    let mut view = RxPdo1600View(&mut image);
    view.set_ready(PDO.ready);
    view.set_level(PDO.level);
    view.set_gear(PDO.gear);
    view.set_torque(PDO.torque);
    view.set_count(PDO.count);
    view.set_signed_five(PDO.signed_five);
    view.set_signed_six(PDO.signed_six);
    view.set_signed_seven(PDO.signed_seven);
    view.set_unsigned_part_1(PDO.unsigned_part_1);
    assert_eq!(image.as_slice(), frame());
    let view = Own::view(&image);
    assert_eq!((view.ready(), view.level(), view.gear()), (OWN.ready, OWN.level, OWN.gear));
    assert_eq!((view.torque(), view.count(), view.five()), (OWN.torque, OWN.count, OWN.five));
    assert_eq!((view.six(), view.seven(), view.part()), (OWN.six, OWN.seven, OWN.part));
}

#[test]
fn an_own_mapping_names_the_bits_of_its_entries() {
    let words: Vec<u32> = Own::MAPPING.iter().map(|mapping| mapping.word()).collect();
    let expected = [
        0x2000_0001,
        0x2001_0003,
        0x2002_0002,
        0x0000_0002,
        0x2003_0018,
        0x0000_0003,
        0x2004_0018,
        0x0000_0005,
        0x2005_0128,
        0x2005_0230,
        0x2005_0338,
        0x2006_0128,
    ];
    assert_eq!(words, expected);
    assert_eq!(Own::ALL[0].index, 0x1601);
}

#[test]
fn a_few_bits_have_the_names_of_their_values() {
    assert_eq!((Gear::SLOW.name(), Gear::BITS), (Some("Slow"), 2));
    assert_eq!(Gear::from_bytes([1]).to_string(), "1: unknown");
}

#[test]
fn each_width_has_its_ends_and_its_type() {
    macro_rules! each {
        ($($name:ident $min:expr, $max:expr, $data_type:ident;)+) => {$({
            use devc_runtime::object::$name as Width;
            assert_eq!((Width::MIN.get(), Width::MAX.get()), ($min, $max));
            assert_eq!((Width::new($min), Width::new($max)), (Some(Width::MIN), Some(Width::MAX)));
            assert_eq!((Width::new($max + 1), Width::saturating($max + 1)), (None, Width::MAX));
            assert_eq!(Width::from_bytes(Width::MAX.to_bytes()), Width::MAX);
            assert_eq!(Width::from_bytes(Width::MIN.to_bytes()), Width::MIN);
            assert_eq!(Width::DATA_TYPE, DataType::$data_type);
        })+};
    }
    each! {
        Int24 -0x80_0000, 0x7F_FFFF, INTEGER24;
        Int40 -0x80_0000_0000, 0x7F_FFFF_FFFF, INTEGER40;
        Int48 -0x8000_0000_0000, 0x7FFF_FFFF_FFFF, INTEGER48;
        Int56 -0x80_0000_0000_0000, 0x7F_FFFF_FFFF_FFFF, INTEGER56;
        Uint24 0, 0xFF_FFFF, UNSIGNED24;
        Uint40 0, 0xFF_FFFF_FFFF, UNSIGNED40;
        Uint48 0, 0xFFFF_FFFF_FFFF, UNSIGNED48;
        Uint56 0, 0xFF_FFFF_FFFF_FFFF, UNSIGNED56;
    }
    assert_eq!((Int24::new(-0x80_0001), Int24::saturating(i64::MIN)), (None, Int24::MIN));
    // ETG.1020, base data types: BIT3
    assert_eq!((Bit3::MAX.get(), Bit3::DATA_TYPE), (7, DataType(0x0032)));
}

#[test]
fn numbers_are_ordered_by_value() {
    assert!(Int24::of::<-1>() < Int24::of::<0>() && Int24::of::<255>() < Int24::of::<256>());
    assert_eq!(Bit3::from_bytes([0xFD]), Bit3::of::<5>());
    assert_eq!(Bit3::from_bytes([0xFD]).to_bytes(), [5]);
}

#[test]
fn a_server_takes_what_fits_and_nothing_else() {
    let mut server = Server::new(Dictionary::DEFAULT, ());
    let (level, torque) = (Address::new(0x2001, 0), Address::new(0x2003, 0));
    let mut buffer = [0; 8];
    assert_eq!(server.upload(torque, PreOperational, &mut buffer), Ok([0xFB, 0xFF, 0xFF].as_slice()));
    assert_eq!(server.upload(level, PreOperational, &mut buffer), Ok([5].as_slice()));
    assert_eq!(server.download(level, PreOperational, &[8]), Err(AbortCode::VALUE_TOO_HIGH));
    assert_eq!(server.download(level, PreOperational, &[7]), Ok(()));
    assert_eq!(server.download(torque, PreOperational, &[1, 0, 0x7F]), Err(AbortCode::VALUE_TOO_HIGH));
    assert_eq!(server.download(torque, PreOperational, &[0xFE, 0xFF, 0xFF]), Ok(()));
    for wrong in [[0; 4].as_slice(), &[0; 2]] {
        assert!(server.download(torque, PreOperational, wrong).is_err());
    }
    let seven = server.upload(Address::new(0x2005, 3), PreOperational, &mut buffer);
    assert_eq!(seven, Ok([0xFE, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF].as_slice()));
    assert_eq!(server.download(Address::new(0x2006, 2), PreOperational, &[1, 2, 3, 4, 5]), Ok(()));
    assert_eq!(server.download(Address::new(0x2002, 0), PreOperational, &[3]), Ok(()));
    let values = &server.values;
    assert_eq!((values.level.get(), values.torque.get(), values.gear), (7, -2, Gear::FAST));
    assert_eq!(values.unsigned[1].get(), 0x05_0403_0201);
}
