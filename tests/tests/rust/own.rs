//! Own mappings and bring-up, against the example of the S700's manual.

use devc_generated::c887;
use devc_generated::pmc_sc6::double;
use devc_generated::s700 as s700_family;
use devc_generated::s700::s700::{self, Controlword, Statusword, objects};
use devc_runtime::pdo::{InPlace, MappedPdo, Pdo, ProcessData, ProcessImage};
use devc_runtime::start_up::{BringUp, StartUp, Write};
use devc_start_up::Interface;
use devc_tests::manual::{rows, s700::Startup};

#[derive(Debug, Clone, Copy, PartialEq, Pdo)]
#[pdo(mapping = s700::FreeRxPdo1600)]
pub(crate) struct Setpoints {
    pub(crate) controlword: Controlword,
    #[pdo(objects::POSITION_SETPOINT)]
    pub(crate) position: i32,
}

#[derive(Debug, Clone, Copy, PartialEq, Pdo)]
#[pdo(mapping = s700::FreeTxPdo1A00)]
pub(crate) struct ActualValues {
    pub(crate) statusword: Statusword,
    pub(crate) position_actual_value_1: i32,
}

#[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
pub(crate) struct Outputs {
    pub(crate) setpoints: Setpoints,
}

#[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
pub(crate) struct Inputs {
    pub(crate) actual_values: ActualValues,
}

/// One for each axis of the double-axis drive.
#[derive(Debug, Clone, Copy, PartialEq, Pdo)]
#[pdo(mapping = double::FreeRxPdo1600, per_axis)]
pub(crate) struct Velocity {
    pub(crate) controlword: double::Controlword,
    pub(crate) modes_of_operation: i8,
    #[pdo(double::objects::vl_target_velocity)]
    pub(crate) velocity: i16,
}

/// With bits that belong to nothing in front, between and behind.
#[derive(Debug, Clone, Copy, PartialEq, Pdo)]
#[pdo(mapping = s700::FreeRxPdo1600, gap = 4)]
pub(crate) struct Gaps {
    #[pdo(gap = 8)]
    pub(crate) controlword: Controlword,
    #[pdo(objects::POSITION_SETPOINT, gap = 20)]
    pub(crate) position: i32,
}

#[derive(Debug, Clone, Copy, PartialEq, ProcessImage)]
pub(crate) struct WithGaps {
    pub(crate) gaps: Gaps,
}

/// 3.6.1: interpolated position mode, 2 ms.
const CHOICE: StartUp = StartUp::of::<Outputs, Inputs>().mode(1).cycle_ns::<2_000_000>();
const LIST: [Write; CHOICE.len()] = CHOICE.writes();
const VERIFY: [Write; CHOICE.verify_len()] = CHOICE.verify();

fn bytes(list: &[Write]) -> Vec<(u16, u8, Vec<u8>)> {
    list.iter().map(|write| (write.address.index, write.address.subindex, write.data().to_vec())).collect()
}

#[test]
fn the_list_is_the_example_of_the_manual_byte_for_byte() {
    let example: Vec<_> = rows::<Startup>()
        .expect("the table is whole")
        .into_iter()
        .map(|row| (row.index, row.sub, row.value))
        .collect();
    let list: Vec<_> = LIST
        .iter()
        .map(|write| {
            let number = write.data().iter().rev().fold(0, |high, byte| high << 8 | u32::from(*byte));
            (write.address.index, write.address.subindex, number)
        })
        .collect();
    assert_eq!(list, example);
}

#[test]
fn what_is_read_back_is_what_was_written_last() {
    let mut last: Vec<Write> = Vec::new();
    for write in LIST {
        last.retain(|other| other.address != write.address);
        last.push(write);
    }
    assert_eq!(bytes(&VERIFY), bytes(&last));
}

/// What is chosen while a program runs is what is chosen while it is compiled.
#[test]
fn the_list_is_the_same_where_a_program_runs() {
    let choice = StartUp::of::<Outputs, Inputs>().mode(1).cycle_ns::<2_000_000>();
    assert_eq!((choice.len(), choice.verify_len(), choice.is_empty()), (LIST.len(), VERIFY.len(), false));
    assert_eq!((choice.writes(), choice.verify()), (LIST, VERIFY));
    assert_eq!(
        StartUp::on::<Outputs, Inputs>(&s700::BRING_UP).mode(1).cycle_ns::<2_000_000>().writes(),
        LIST
    );
}

#[test]
#[should_panic(expected = "S300 does not take this cycle time")]
fn a_cycle_time_that_the_device_does_not_take_is_refused() {
    let _ = StartUp::of::<Outputs, Inputs>().cycle_ns::<1_000>();
}

#[test]
#[should_panic(expected = "the cycle time is not up to 255 of a power of ten of a second")]
fn a_cycle_time_that_cannot_be_written_is_refused() {
    let _ = StartUp::of::<Outputs, Inputs>().cycle_ns::<257_000>();
}

/// What 0x60C2 gets: the count and the power of ten.
macro_rules! period {
    ($ns:literal) => {{
        const CHOICE: StartUp = StartUp::of::<Outputs, Inputs>().cycle_ns::<$ns>();
        let list: [Write; CHOICE.len()] = CHOICE.writes();
        let [.., count, exponent] = list.as_slice() else { panic!("there are two writes") };
        (count.data()[0], exponent.data()[0] as i8)
    }};
}

#[test]
fn a_cycle_time_is_counted_in_the_largest_unit_that_fits() {
    assert_eq!(period!(1_000_000), (1, -3));
    assert_eq!(period!(250_000), (25, -5));
    assert_eq!(period!(255_000), (255, -6));
    assert_eq!(period!(200_000_000), (200, -3));
}

#[test]
fn an_own_mapping_packs_its_entries_in_a_row() {
    assert_eq!((Setpoints::INDEX, Setpoints::LEN, Outputs::LEN), (0x1600, 6, 6));
    let setpoints = Setpoints { controlword: Controlword(0x0201), position: 0x0605_0403 };
    assert_eq!(setpoints.pack(), [1, 2, 3, 4, 5, 6]);
    assert_eq!(Setpoints::unpack([1, 2, 3, 4, 5, 6]), setpoints);
    let mut frame = [0; 6];
    Setpoints::view(&mut frame).set_position(0x0605_0403);
    assert_eq!(frame, [0, 0, 3, 4, 5, 6]);
    let mut view = OutputsView(&mut frame);
    view.setpoints_mut().set_controlword(Controlword(0x0201));
    assert_eq!(frame, Outputs { setpoints }.pack());
}

#[test]
fn each_axis_has_the_mapping_of_its_own_objects() {
    let words = |axis: usize| -> Vec<u32> {
        Velocity::ALL[axis].mapping.iter().map(|mapping| mapping.word()).collect()
    };
    assert_eq!(words(0), [0x6040_0010, 0x6060_0008, 0x6042_0010]);
    assert_eq!(words(1), [0x6840_0010, 0x6860_0008, 0x6842_0010]);
    let indices: Vec<u16> = Velocity::ALL.iter().map(|pdo| pdo.index).collect();
    assert_eq!(indices, double::RxPdo1600::ALL.iter().map(|pdo| pdo.index).collect::<Vec<_>>());
}

/// ETG.1000.6, PDO mapping: a gap is a line with index 0, subindex 0 and the bits.
#[test]
fn gaps_are_lines_of_the_mapping() {
    const LIST: [Write; StartUp::of::<WithGaps, Inputs>().len()] = StartUp::of::<WithGaps, Inputs>().writes();
    let of_mapping = LIST.iter().filter(|write| write.address.index == 0x1600);
    let written: Vec<_> = of_mapping.map(|write| (write.address.subindex, write.data())).collect();
    let words: [u32; 5] = [0x0000_0008, 0x6040_0010, 0x0000_0014, 0x60C1_0020, 0x0000_0004];
    let words = words.map(u32::to_le_bytes);
    let lines = (1..).zip(words.iter().map(<[u8; 4]>::as_slice));
    assert!(
        written.into_iter().eq([(0, [0].as_slice())].into_iter().chain(lines).chain([(0, [5].as_slice())]))
    );
}

#[test]
fn gaps_are_sent_as_zeros_and_not_read() {
    assert_eq!((Gaps::LEN, WithGaps::LEN), (10, 10));
    let gaps = Gaps { controlword: Controlword(0x0201), position: 0x7654_3210 };
    let packed = [0, 0x01, 0x02, 0, 0, 0x00, 0x21, 0x43, 0x65, 0x07];
    assert_eq!(gaps.pack(), packed);
    assert_eq!(Gaps::unpack(packed), gaps);
    let of_others = [0xFF, 0, 0, 0xFF, 0xFF, 0x0F, 0, 0, 0, 0xF0];
    let filled: [u8; 10] = core::array::from_fn(|at| packed[at] | of_others[at]);
    assert_eq!(Gaps::unpack(filled), gaps);
    let mut frame = of_others;
    let mut view = Gaps::view(&mut frame);
    view.set_controlword(gaps.controlword);
    view.set_position(gaps.position);
    assert_eq!(frame, filled);
}

/// What each takes: the S600 a position every millisecond, a velocity every 500 µs and a torque every 250 µs (S700, 3.10);
/// the C-887 anything every millisecond (C887T0011, p. 4).
#[test]
fn a_device_takes_its_cycle_times_only() {
    let takes = |device: &BringUp, mode, ns| Interface { mode, pdos: [&[], &[]] }.takes(device.cycles, ns);
    let s600 = &s700_family::s600::BRING_UP;
    for (mode, least) in [(8, 1_000_000), (9, 500_000), (10, 250_000), (-2, 500_000)] {
        assert!(takes(s600, Some(mode), least), "{mode}");
        assert!(!takes(s600, Some(mode), least - 1), "{mode}");
    }
    assert!(takes(s600, None, 250_000) && !takes(s600, None, 200_000));
    assert!(takes(&s700::BRING_UP, Some(8), 250_000) && !takes(&s700::BRING_UP, Some(8), 200_000));
    assert!(takes(&c887::BRING_UP, Some(8), 1_000_000) && !takes(&c887::BRING_UP, None, 250_000));
}

/// Its position setpoint alone makes an interface one for positions.
#[test]
fn an_interface_has_the_cycle_time_of_its_pdos() {
    let with = |index| [MappedPdo::new(index, &[])];
    let takes = |pdos: &[MappedPdo], ns| {
        Interface { mode: None, pdos: [pdos, &[]] }.takes(s700_family::s600::BRING_UP.cycles, ns)
    };
    let position = with(s700_family::RxPdo1701::INDEX);
    assert!(!takes(&position, 250_000) && takes(&position, 1_000_000));
}
