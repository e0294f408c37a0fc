//! Structs and attributes in all the forms that Rust has for them.
#![expect(unreachable_pub, reason = "a device is public, a test is not")]
#![expect(unused_parens, reason = "they are one of the forms")]

use devc_runtime::Device;
use devc_runtime::pdo::{InPlace, Mapping, Pdo, ProcessData, ProcessImage};

use hexapod::{Axis, RxPdo1600, RxPdo1601};

mod fieldbus {
    pub(crate) use devc_runtime as runtime;
}

/// The runtime by another name; and where clauses that need no parameter.
#[derive(Debug, Device)]
#[cfg_attr(true, device(path = "../devices/c887", runtime = crate::forms::fieldbus::runtime))]
#[device(module = "hexapod")]
#[doc = concat!("An attribute", " with a macro in it.")]
pub struct Controller
where
    u8: Copy;

/// A macro of a library that has the runtime in it.
macro_rules! device {
    ($(#[$meta:meta])* $visibility:vis $name:ident, $path:literal, $member:expr) => {
        #[derive(Device)]
        $(#[$meta])*
        #[device(path = $path, runtime = $crate::forms::fieldbus::runtime, member = $member)]
        $visibility struct $name;
    };
}

device!(#[derive(Debug)] pub r#S700, "../devices/s700", "s700");
device!(#[device(module = sc6)] pub DoubleAxis, "../devices/pmc-sc6", "double");

#[test]
fn devices_are_read_in_every_form() {
    assert_eq!(Controller::NAME, "C-887.53x");
    assert_eq!(hexapod::objects::controlword(Axis::Y).address().index, 0x6840);
    assert_eq!(s700::objects::CONTROLWORD.address().index, 0x6040);
    assert_eq!(sc6::objects::controlword(sc6::Axis::B).address().index, 0x6840);
}

const FIRST: Axis = Axis::V;

const fn second<const A: u8, const B: u8>() -> u8 {
    A + B
}

/// Attributes that are configured, axes by expressions of every kind.
#[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
#[image(runtime = "devc_runtime")]
pub(in crate::forms) struct Outputs
where
    u8: Copy,
{
    /// A field with documentation, and one without.
    #[cfg(true)]
    #[cfg_attr(true, image(axis = Axis::ALL[2]))]
    #[cfg_attr(false, image(axis = Axis::W))]
    pub(in crate::forms) r#type: (RxPdo1600),
    #[cfg(false)]
    absent: NoSuchType,
    #[image(axis = FIRST)]
    #[allow(dead_code, reason = "an attribute of another")]
    in_a_row: [(RxPdo1601); (2_usize)],
    #[image(axis = second::<0, 1>())]
    called: RxPdo1601,
    #[image(axis = if cfg!(false) { 5 } else { 0 },)]
    chosen: hexapod::RxPdo1601,
}

#[test]
fn images_are_read_in_every_form() {
    let indices: Vec<u16> = Outputs::PDOS.iter().map(|pdo| pdo.index).collect();
    assert_eq!(indices, [0x1620, 0x1641, 0x1651, 0x1611, 0x1601]);
    let mut bytes = [0; Outputs::LEN];
    let mut view = Outputs::view(&mut bytes);
    view.type_mut().set_target_position(-2);
    assert_eq!(Outputs::unpack(bytes).r#type.target_position, -2);
}

/// A struct that a macro makes of all that it is given.
macro_rules! image {
    (
        $(#[$meta:meta])* $visibility:vis struct $name:ident;
        $($(#[$on:meta])* $field:ident: $pdo:ty, $axis:expr);*
    ) => {
        $(#[$meta])*
        $visibility struct $name {
            $($(#[$on])* #[image(axis = $axis)] $field: $pdo,)*
        }
    };
}

image! {
    #[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
    pub(crate) struct Made;
    #[cfg(false)] absent: RxPdo1601, 0;
    rows: [RxPdo1600; 2], Axis::Y;
    #[cfg(true)] single: RxPdo1601, { FIRST }
}

#[test]
fn images_are_made_by_macros() {
    let indices: Vec<u16> = Made::PDOS.iter().map(|pdo| pdo.index).collect();
    assert_eq!(indices, [0x1610, 0x1620, 0x1641]);
}

/// Entries as a path, by name, and in parentheses; gaps beside them.
#[derive(Debug, Clone, Copy, PartialEq, Pdo)]
#[pdo(mapping = s700::FreeRxPdo1600, gap = 0x4,)]
struct Setpoints {
    /// Its entry has its name.
    r#controlword: s700::Controlword,
    #[cfg_attr(true, pdo(gap = 20))]
    #[pdo(s700::objects::POSITION_SETPOINT)]
    r#type: i32,
    #[cfg(false)]
    #[pdo(gap = 8)]
    absent: i32,
}

macro_rules! mapping {
    ($free:ty, $(#[$meta:meta])* $name:ident, $($entry:expr => $field:ident: $content:ty, $gap:literal);*) => {
        #[derive(Debug, Clone, Copy, PartialEq, Pdo)]
        $(#[$meta])*
        #[pdo(mapping = $free)]
        struct $name {
            $(#[pdo($entry, gap = $gap)] $field: $content,)*
        }
    };
}

mapping!(s700::FreeTxPdo1A00, ActualValues, { s700::objects::STATUSWORD } => status: s700::Statusword, 8;
    (s700::objects::POSITION_ACTUAL_VALUE_1) => position: i32, 16);
mapping!(sc6::FreeRxPdo1600, #[pdo(per_axis)] Velocity, sc6::objects::controlword => word: sc6::Controlword, 8;
    sc6::objects::vl_target_velocity => velocity: i16, 16);

/// ETG.1000.6, PDO mapping: index, subindex and bits of each entry; a gap has only bits.
fn words(mapping: &[Mapping]) -> Vec<u32> {
    mapping.iter().map(|line| line.word()).collect()
}

#[test]
fn mappings_are_read_in_every_form() {
    assert_eq!(words(Setpoints::MAPPING), [0x6040_0010, 0x0000_0014, 0x60C1_0020, 0x0000_0004]);
    let mut bytes = [0; Setpoints::LEN];
    Setpoints::view(&mut bytes).set_type(0x0765_4321);
    assert_eq!(Setpoints::unpack(bytes).r#type, 0x0765_4321);
}

#[test]
fn mappings_are_made_by_macros() {
    assert_eq!(words(ActualValues::MAPPING), [0x0000_0008, 0x6041_0010, 0x0000_0010, 0x6063_0020]);
    assert_eq!(words(Velocity::ALL[1].mapping), [0x0000_0008, 0x6840_0010, 0x0000_0010, 0x6842_0010]);
}
