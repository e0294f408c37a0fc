//! Whole images of selections other than the default one, against the manual's tables of PDOs.

use devc_generated::c887::{self, Axis, RxPdo1600, RxPdo1601, TxPdo1A00, TxPdo1A01};
use devc_generated::pmc_sc6;
use devc_generated::s700::s700;
use devc_runtime::pdo::{Direction, ProcessData, ProcessImage};
use devc_tests::manual::c887::Assigned;
use devc_tests::manual::{Direction as Way, rows};

/// Half of the axes follow set-points, the others move on their own.
#[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
pub(crate) struct Mixed {
    pub(crate) cyclic: [RxPdo1600; 3],
    #[image(axis = Axis::U)]
    pub(crate) profile: [RxPdo1601; 3],
}

/// A single axis is of interest, another alone behind it.
#[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
pub(crate) struct Watched {
    #[image(axis = Axis::Z)]
    pub(crate) z: TxPdo1A01,
    #[image(axis = 0)]
    pub(crate) x: c887::TxPdo1A00,
}

#[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
pub(crate) struct TorqueOutputs {
    pub(crate) pdo: s700::RxPdo1703,
}

#[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
pub(crate) struct BothAxes {
    pub(crate) axes: [pmc_sc6::double::RxPdo1600; 2],
}

fn indices<I: ProcessImage>() -> Vec<u16> {
    I::PDOS.iter().map(|pdo| pdo.index).collect()
}

#[test]
fn a_selection_names_the_pdos_of_its_axes() {
    assert_eq!(indices::<Mixed>(), [0x1600, 0x1610, 0x1620, 0x1631, 0x1641, 0x1651]);
    assert_eq!(indices::<Watched>(), [0x1A21, 0x1A00]);
    assert_eq!(indices::<TorqueOutputs>(), [0x1703]);
    assert_eq!(<Mixed as ProcessData>::Direction::ASSIGNMENT, 0x1C12);
    assert_eq!(<Watched as ProcessData>::Direction::ASSIGNMENT, 0x1C13);
    let mapped: Vec<u32> = Mixed::PDOS[4].mapping.iter().map(|mapping| mapping.word()).collect();
    let of_v = [0x6040_0010, 0x6060_0008, 0x607A_0020, 0x6081_0020, 0x6083_0020];
    assert_eq!(mapped, of_v.map(|word| word + (0x2000 << 16)));
}

#[test]
fn the_default_image_names_what_the_manual_assigns() {
    let assigned = rows::<Assigned>().expect("the table is whole");
    let of = |way| assigned.iter().filter(move |row| row.direction == way).filter_map(|row| row.pdo);
    assert!(of(Way::Rx).eq(indices::<c887::Outputs>()));
    assert!(of(Way::Tx).eq(indices::<c887::Inputs>()));
    assert_eq!(indices::<pmc_sc6::double::Outputs>(), indices::<BothAxes>());
}

#[test]
fn an_image_is_its_pdos_one_after_the_other() {
    assert_eq!((Mixed::LEN, Watched::LEN), (3 * 7 + 3 * 15, 7 + 11));
    let image: [u8; 66] = core::array::from_fn(|n| n as u8);
    let value = Mixed::unpack(image);
    for axis in 0..3 {
        assert_eq!(value.cyclic[axis].pack(), image[7 * axis..][..7]);
        assert_eq!(value.profile[axis].pack(), image[21 + 15 * axis..][..15]);
    }
    assert_eq!(value.pack(), image);
    let image: [u8; 18] = core::array::from_fn(|n| n as u8);
    let value = Watched::unpack(image);
    assert_eq!(
        (value.z, value.x),
        (TxPdo1A01::unpack_from(&image[..7]).unwrap(), TxPdo1A00::unpack_from(&image[7..]).unwrap())
    );
    assert_eq!(value.pack(), image);
}

#[test]
fn a_selection_is_seen_in_place() {
    let mut image: [u8; 66] = core::array::from_fn(|n| n as u8);
    let value = Mixed::unpack(image);
    let view = MixedView(&image);
    let [_, _, third] = view.profile();
    assert_eq!(third.profile_acceleration(), value.profile[2].profile_acceleration);
    let mut view = MixedView(&mut image);
    let [first, ..] = view.profile_mut();
    first.0.fill(0xFF);
    assert_eq!(image[21..36], [0xFF; 15]);
    assert_eq!((image[20], image[36]), (20, 36));
    let mut image = [0; 18];
    WatchedView(&mut image).x_mut().set_position_actual_value(-1);
    assert_eq!(image[10..14], [0xFF; 4]);
    assert_eq!(WatchedView(image).x().position_actual_value(), -1);
}
