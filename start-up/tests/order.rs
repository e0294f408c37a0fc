//! The order of ETG.1020, start-up: nothing is assigned while mappings change, nothing is counted before it is there.

#![allow(clippy::expect_used)] // a test may

use devc_start_up::{Address, AxisObjects, Carrier, Choice, MappedPdo, Mapping, Period, Step, Way};

const WORD: Mapping = Mapping { address: Address::new(0x6040, 0), bits: 16 };
const POSITION: Mapping = Mapping { address: Address::new(0x607A, 0), bits: 32 };
const OUTPUTS: [Carrier<'static>; 1] = [Carrier { assignment: 0x1C12, pdos: &[0x1600] }];
const INPUTS: [Carrier<'static>; 1] = [Carrier { assignment: 0x1C13, pdos: &[0x1A00] }];

fn steps(choice: Choice<'_>) -> Vec<Step> {
    let mut steps = vec![Step::NONE; choice.steps(&mut [])];
    assert_eq!(choice.steps(&mut steps), steps.len());
    steps
}

/// Index, subindex and the number that is written.
fn written(steps: &[Step]) -> Vec<(u16, u8, u32)> {
    let number = |step: &Step| step.data().iter().rev().fold(0, |high, byte| high << 8 | u32::from(*byte));
    steps.iter().map(|step| (step.address.index, step.address.subindex, number(step))).collect()
}

fn is_assignment(index: u16) -> bool {
    (0x1C10..=0x1C2F).contains(&index)
}

/// What the standard asks for, of any list.
fn is_in_order(list: &[(u16, u8, u32)]) {
    for (place, (index, subindex, value)) in list.iter().enumerate() {
        let before = list.get(..place).expect("it is a place of the list");
        let count = before.iter().rev().find(|(of, subindex, _)| of == index && *subindex == 0);
        match subindex {
            // an entry is written only while there is none, and one after the other
            1.. if is_assignment(*index) || *index < 0x1C00 => {
                assert_eq!(count.map(|(.., count)| *count), Some(0), "{list:X?}");
            }
            0 if *value > 0 && *index < 0x2000 => {
                let entries = before.iter().filter(|(of, subindex, _)| of == index && *subindex > 0);
                let numbers: Vec<u32> = entries.map(|(_, subindex, _)| u32::from(*subindex)).collect();
                assert_eq!(numbers, (1..=*value).collect::<Vec<_>>(), "{list:X?}");
            }
            _ => {}
        }
        // mappings change while nothing is assigned
        if *index < 0x1C00 {
            let assigned = before.iter().filter(|(of, ..)| is_assignment(*of));
            assert!(assigned.clone().count() > 0 && assigned.clone().all(|(.., value)| *value == 0));
        }
    }
}

#[test]
fn both_directions_are_chosen_in_the_order_of_the_standard() {
    let (rx, tx) = (MappedPdo::own(0x1600, &[WORD, POSITION]), MappedPdo::own(0x1A00, &[WORD]));
    let (rx, tx) = ([rx, MappedPdo::new(0x1601, &[WORD])], [tx]);
    let axes = [AxisObjects { mode: Some(0x6060), cycle: Some(0x60C2) }];
    let choice = Choice {
        outputs: Way { carriers: &OUTPUTS, mapped: &rx, assigned: Some(&rx) },
        inputs: Way { carriers: &INPUTS, mapped: &tx, assigned: Some(&tx) },
        axes: &axes,
        mode: Some(-1),
        cycle: Period::of_ns(250_000),
    };
    let list = written(&steps(choice));
    is_in_order(&list);
    let assigned: Vec<_> = list.iter().filter(|(index, ..)| *index == 0x1C12).copied().collect();
    assert_eq!(assigned, [(0x1C12, 0, 0), (0x1C12, 1, 0x1600), (0x1C12, 2, 0x1601), (0x1C12, 0, 2)]);
    // only what is a master's own is mapped
    assert!(list.iter().all(|(index, ..)| *index != 0x1601));
    let tail = list.get(list.len() - 3..);
    assert_eq!(tail, Some([(0x6060, 0, 0xFF), (0x60C2, 1, 25), (0x60C2, 2, 0xFB)].as_slice()));
    // what is read back is what each entry was written last
    let mut lasting = vec![Step::NONE; choice.lasting(&mut [])];
    choice.lasting(&mut lasting);
    let mut last: Vec<(u16, u8, u32)> = Vec::new();
    for write in list {
        last.retain(|(index, subindex, _)| (*index, *subindex) != (write.0, write.1));
        last.push(write);
    }
    assert_eq!(written(&lasting), last);
}

#[test]
fn nothing_at_all_is_assigned_if_that_is_chosen() {
    let outputs = Way { carriers: &OUTPUTS, mapped: &[], assigned: Some(&[]) };
    let list = written(&steps(Choice { outputs, ..Choice::NONE }));
    assert_eq!(list, [(0x1C12, 0, 0), (0x1C12, 0, 0)]);
    assert_eq!(steps(Choice::NONE), []);
}

/// A device may let a master map and not assign; what is mapped then is what it carries anyway.
#[test]
fn what_is_mapped_need_not_be_assigned() {
    let own = [MappedPdo::own(0x1600, &[WORD])];
    let outputs = Way { carriers: &OUTPUTS, mapped: &own, assigned: None };
    let list = written(&steps(Choice { outputs, ..Choice::NONE }));
    assert_eq!(list, [(0x1600, 0, 0), (0x1600, 1, 0x6040_0010), (0x1600, 0, 1)]);
}

/// ETG.1000.6, sync manager PDO assignment: each sync manager has an object of its own.
#[test]
fn a_pdo_goes_to_the_sync_manager_that_carries_it() {
    let carriers = [
        Carrier { assignment: 0x1C12, pdos: &[0x1600] },
        Carrier { assignment: 0x1C14, pdos: &[0x1610, 0x1611] },
        Carrier { assignment: 0x1C16, pdos: &[0x1620] },
    ];
    // 0x1630 is carried by none: the first takes it
    let pdos = [0x1611, 0x1630, 0x1600, 0x1610].map(|index| MappedPdo::new(index, &[]));
    let outputs = Way { carriers: &carriers, mapped: &pdos, assigned: Some(&pdos) };
    let list = written(&steps(Choice { outputs, ..Choice::NONE }));
    is_in_order(&list);
    let [first, second, third] = [0x1C12, 0x1C14, 0x1C16].map(|assignment| {
        let pdos = list.iter().filter(|(index, subindex, _)| *index == assignment && *subindex > 0);
        pdos.map(|(.., pdo)| *pdo).collect::<Vec<_>>()
    });
    assert_eq!((first, second, third), (vec![0x1630, 0x1600], vec![0x1611, 0x1610], vec![]));
}

/// Subindices end at 254, however long what is given is; what does not fit is counted.
#[test]
fn lists_end_where_subindices_end() {
    let (many, few) = ([WORD; 300], [MappedPdo::new(0x1600, &[]); 300]);
    let own = [MappedPdo::own(0x1600, &many)];
    let outputs = Way { carriers: &OUTPUTS, mapped: &own, assigned: Some(&few) };
    let choice = Choice { outputs, ..Choice::NONE };
    assert_eq!(choice.steps(&mut []), 2 * (254 + 2));
    let mut one = [Step::NONE];
    assert_eq!(choice.steps(&mut one), 2 * (254 + 2));
    assert_eq!(written(&one), [(0x1C12, 0, 0)]);
}
