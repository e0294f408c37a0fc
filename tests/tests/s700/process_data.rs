//! Fixed and free mappings against the chapters on them.

use std::collections::BTreeSet;

use devc::model::{Address, Index, Pdo, Role};
use devc_tests::manual::{Direction, s700};

use crate::{MEMBERS, departs, device, fact, holds_for, number, plain, rows};

/// The object that each name of the list of fixed mappings stands for; the list names no objects.
const MEANT: [(&str, u16, u8); 48] = [
    ("Position setpoint", 0x60C1, 0),
    ("Controlword", 0x6040, 0),
    ("Velocity setpoint", 0x60FF, 0),
    ("Current setpoint", 0x6071, 0),
    ("OPMODE request", 0x2352, 0),
    ("Additive Current setpoint", 0x2307, 0),
    ("Current limit", 0x2061, 0),
    ("Latchcontrolword", 0x20A4, 0),
    ("Latchcontrolwort", 0x20A4, 0),
    ("set value for digital output1/bit 0 and output2/bit 1", 0x2302, 0),
    ("target position O_P", 0x607A, 0),
    ("target velocity O_V", 0x6081, 0),
    ("motion task control word O_C", 0x2303, 0),
    ("MT acceleration O_ACC", 0x6083, 0),
    ("MT deceleration O_DEC", 0x6084, 0),
    ("MT profile O_TAB", 0x6086, 0),
    ("Velocity feed forward", 0x2308, 0),
    ("current feed forward", 0x2307, 0),
    ("user variable DPRVAR2", 0x2306, 0),
    ("user variable DPRVAR3", 0x2090, 3),
    ("user variable DPRVAR4", 0x2090, 4),
    ("user variable DPRVAR5", 0x2090, 5),
    ("user variable DPRVAR6", 0x2090, 6),
    ("Position act.value", 0x6063, 0),
    ("Statusword", 0x6041, 0),
    ("Current act.value", 0x6077, 0),
    ("OPMODE status", 0x2353, 0),
    ("Opmode message", 0x2353, 0),
    ("Drive-following-error", 0x60F4, 0),
    ("following error", 0x60F4, 0),
    ("Latchstatusword", 0x20A5, 0),
    ("Latchposition", 0x20A0, 0),
    ("Position act.value 2", 0x2050, 0),
    ("Position actual value 2", 0x2050, 0),
    ("Velocity actual value", 0x606C, 0),
    ("Current actual value", 0x6077, 0),
    ("Drive error status", 0x1003, 0),
    ("Drive warnings", 0x2000, 0),
    ("digital input state", 0x60FD, 0),
    ("analog input 1", 0x20B2, 1),
    ("analog input 2", 0x20B2, 2),
    ("Motion task status TRJSTAT", 0x1002, 0),
    ("user variable DPRVAR9", 0x2350, 1),
    ("user variable DPRVAR10", 0x2030, 2),
    ("user variable DPRVAR11", 0x2030, 3),
    ("user variable DPRVAR12", 0x2350, 4),
    ("user variable DPRVAR13", 0x2350, 5),
    ("user variable DPRVAR14", 0x2030, 6),
];

fn meant(name: &str) -> Address {
    let found = MEANT.iter().find(|(printed, ..)| plain(printed) == plain(name));
    let (_, index, subindex) = found.unwrap_or_else(|| panic!("{name:?} is a new name"));
    Address { index: Index(*index), subindex: *subindex }
}

/// The fixed mapping of a member, if it has it.
fn fixed(member: devc_tests::manual::Member, index: u16) -> Option<&'static Pdo> {
    device(member).pdo(Index(index)).filter(|pdo| pdo.fixed)
}

#[test]
fn fixed_mappings_are_those_of_each_member() {
    for member in MEMBERS {
        let rows = rows::<s700::Pdo>().into_iter().filter(|row| holds_for(&row.members, member));
        let printed: BTreeSet<_> = rows.map(|row| (row.pdo, row.direction == Direction::Rx)).collect();
        let pdos = device(member).pdos.iter().filter(|pdo| pdo.fixed);
        let described = pdos.map(|pdo| (pdo.index.0, pdo.direction == devc::model::Direction::Rx)).collect();
        assert_eq!(printed, described, "{member:?}");
    }
}

#[test]
fn entries_are_those_of_the_list() {
    let mut compared = 0;
    for member in MEMBERS {
        for row in rows::<s700::Entry>() {
            let Some(pdo) = fixed(member, row.pdo) else { continue };
            let place = format!("0x{:04X} entry {} of {member:?}", row.pdo, row.position);
            let entry = pdo.entries.get(usize::from(row.position) - 1);
            let entry = entry.unwrap_or_else(|| panic!("there is no {place}"));
            assert_eq!(entry.address, Some(meant(row.name)), "{place}, {}", row.name);
            assert_eq!(entry.bits, u32::from(row.bytes) * 8, "{place}");
            compared += 1;
        }
        for pdo in device(member).pdos.iter().filter(|pdo| pdo.fixed) {
            let printed = rows::<s700::Entry>().into_iter().filter(|row| row.pdo == pdo.index.0).count();
            assert_eq!(pdo.entries.len(), printed, "{}", pdo.index);
        }
    }
    // All of the 118 on two members; on the others without the 54 of the mappings from 9 on.
    assert_eq!(compared, 2 * 118 + 2 * (118 - 54));
}

#[test]
fn every_name_is_used() {
    let printed: BTreeSet<_> = rows::<s700::Entry>().iter().map(|row| plain(row.name)).collect();
    let known: BTreeSet<_> = MEANT.iter().map(|(name, ..)| plain(name)).collect();
    assert_eq!(known, printed);
}

#[test]
fn widths_are_those_of_the_objects_but_for_two() {
    let other = MEMBERS.into_iter().flat_map(|member| {
        device(member).pdos.iter().flat_map(move |pdo| {
            let entries = (1_u8..).zip(&pdo.entries);
            let wrong = entries.filter(move |(_, mapped)| {
                let entry = mapped.address.and_then(|address| device(member).entry(address));
                entry.is_none_or(|entry| entry.data_type.bits() != mapped.bits)
            });
            wrong.map(|(position, _)| (pdo.index.0, position))
        })
    });
    let known = [
        ((0x1710, 6), "0x6086 is INT32, and the total only comes out with 2 bytes"),
        ((0x1B0B, 8), "0x60FD is INT16, and the total only comes out with 4 bytes"),
    ];
    departs(other, known);
}

#[test]
fn totals_are_kept_and_right_but_for_two() {
    let mut wrong = BTreeSet::new();
    for row in rows::<s700::Pdo>() {
        for member in MEMBERS {
            let Some(pdo) = fixed(member, row.pdo) else { continue };
            assert_eq!(pdo.total, Some(row.total.into()), "{}", pdo.index);
            if pdo.bytes() != u32::from(row.total) {
                wrong.insert((row.pdo, row.total, pdo.bytes()));
            }
        }
    }
    let why = "the totals of the two are swapped";
    departs(wrong, [((0x170A, 10, 8), why), ((0x1B0A, 8, 10), why)]);
}

#[test]
fn pairs_are_those_of_the_list() {
    for row in rows::<s700::Interface>() {
        for member in MEMBERS {
            let pdo = fixed(member, row.rx);
            assert_eq!(pdo.is_some(), holds_for(&row.members, member), "item {}", row.item);
            assert_eq!(fixed(member, row.tx).is_some(), row.example || pdo.is_some(), "item {}", row.item);
            let Some(about) = pdo.map(|pdo| pdo.about.as_deref().unwrap_or_default()) else { continue };
            let pair = if row.example { ", for example." } else { "." };
            let pair = format!("Goes with 0x{:04X}{pair}", row.tx);
            assert!(about.contains(&pair), "item {}: {pair}", row.item);
        }
    }
}

#[test]
fn one_mapping_is_assigned_and_which_depends_on_the_member() {
    for member in MEMBERS {
        let defaults = rows::<s700::Pdo>().into_iter().filter(|row| row.default.contains(&member));
        let defaults: Vec<_> = defaults.map(|row| Index(row.pdo)).collect();
        let outputs = device(member).sync_manager(Role::Outputs).expect("there are outputs");
        assert_eq!((&outputs.pdos, outputs.slots), (&defaults, 1), "{member:?}");
        let inputs = device(member).sync_manager(Role::Inputs).expect("there are inputs");
        let default = Index(u16::try_from(number("free-default-tx")).expect("an index"));
        assert_eq!((&inputs.pdos, inputs.slots), (&vec![default], 1), "{member:?}");
    }
}

#[test]
fn long_mappings_need_extended_memory() {
    let parameter = fact("extended-mapping-parameter");
    for member in MEMBERS {
        for pdo in device(member).pdos.iter().filter(|pdo| pdo.fixed) {
            let long = pdo.bytes() > number("extended-mapping-above-bytes");
            let says = pdo.about.as_deref().is_some_and(|about| about.contains(parameter));
            assert_eq!(says, long, "{}", pdo.index);
            assert!(
                !long || fact("extended-mapping-members").contains(&device(member).name),
                "{}",
                pdo.index
            );
        }
    }
}

#[test]
fn free_mappings_are_those_of_the_manual() {
    for member in MEMBERS {
        let free: BTreeSet<_> =
            device(member).pdos.iter().filter(|pdo| !pdo.fixed).map(|pdo| u32::from(pdo.index.0)).collect();
        let has = fact("free-mapping-members").contains(&device(member).name);
        let printed = [number("free-rx"), number("free-tx")].into_iter().filter(|_| has).collect();
        assert_eq!(free, printed, "{member:?}");
        for pdo in device(member).pdos.iter().filter(|pdo| !pdo.fixed) {
            assert_eq!(pdo.max_bytes.map(u32::from), Some(number("free-max-bytes")));
        }
    }
}
