//! Where the standards have what a profile says: the number of the document and its clause.

use std::ops::RangeInclusive;

use super::entity::Entity;
use crate::source::keys;

/// The profile, the section, the numbers of its things, and where they are defined. The first that fits counts.
type Clause = (&'static str, &'static str, RangeInclusive<u16>, &'static str);

const ANY: RangeInclusive<u16> = 0..=0xFFFF;

/// IEC 61800-7-201 has the profile that CiA 402-2 has, in clauses of the same names.
#[rustfmt::skip] // a line each
const CLAUSES: &[Clause] = &[
    ("ethercat", "objects", 0x1000..=0x1003, "CiA 301, general communication objects; ETG.1000.6, CoE communication area"),
    ("ethercat", "objects", 0x1008..=0x100A, "CiA 301, general communication objects; ETG.1000.6, CoE communication area"),
    ("ethercat", "objects", 0x1010..=0x1010, "CiA 301, store parameters"),
    ("ethercat", "objects", 0x1011..=0x1011, "CiA 301, restore default parameters"),
    ("ethercat", "objects", 0x1018..=0x1018, "CiA 301, identity object; ETG.1000.6, identity object"),
    ("ethercat", "objects", 0x10F0..=0x10F0, "ETG.1020, backup parameter handling"),
    ("ethercat", "objects", 0x10F1..=0x10F1, "ETG.1020, error settings"),
    ("ethercat", "objects", 0x10F3..=0x10F3, "ETG.1020, diagnosis history"),
    ("ethercat", "objects", 0x10F8..=0x10F8, "ETG.1020, timestamp object"),
    ("ethercat", "objects", 0x1400..=0x15FF, "ETG.1020, RxPDO parameter"),
    ("ethercat", "objects", 0x1800..=0x19FF, "ETG.1020, TxPDO parameter"),
    ("ethercat", "objects", 0x1C00..=0x1C00, "ETG.1000.6, sync manager communication type"),
    ("ethercat", "objects", 0x1C10..=0x1C2F, "ETG.1000.6, sync manager PDO assignment"),
    ("ethercat", "objects", 0x1C30..=0x1C4F, "ETG.1000.6, sync manager synchronization; ETG.1020, synchronization"),
    ("ethercat", "objects", 0xF000..=0xF0FF, "ETG.5001, modular device profile"),
    ("ethercat", "abort-codes", ANY, "ETG.1000.6, SDO abort codes; CiA 301, abort SDO transfer protocol"),
    ("ethercat", "words", ANY, "CiA 301, error register"),
    ("ethercat", "communication-states", ANY, "ETG.1000.6, EtherCAT state machine"),
    ("ethercat", "communication-transitions", ANY, "ETG.1000.6, EtherCAT state machine"),
    ("ethercat", "al-status-codes", ANY, "ETG.1000.6, AL status codes; ETG.1020, AL status codes"),
    ("cia402", "objects", 0x6007..=0x6007, "IEC 61800-7-201, common entries"),
    ("cia402", "objects", 0x603F..=0x603F, "IEC 61800-7-201, error codes"),
    ("cia402", "objects", 0x6040..=0x6041, "IEC 61800-7-201, device control"),
    ("cia402", "objects", 0x6042..=0x6059, "IEC 61800-7-201, velocity mode"),
    ("cia402", "objects", 0x605A..=0x605E, "IEC 61800-7-201, device control"),
    ("cia402", "objects", 0x6060..=0x6061, "IEC 61800-7-201, modes of operation"),
    ("cia402", "objects", 0x6062..=0x6068, "IEC 61800-7-201, position control function"),
    ("cia402", "objects", 0x6069..=0x6070, "IEC 61800-7-201, profile velocity mode"),
    ("cia402", "objects", 0x6071..=0x6079, "IEC 61800-7-201, profile torque mode"),
    ("cia402", "objects", 0x607C..=0x607C, "IEC 61800-7-201, homing mode"),
    ("cia402", "objects", 0x607E..=0x607E, "IEC 61800-7-201, factor group"),
    ("cia402", "objects", 0x607A..=0x6086, "IEC 61800-7-201, profile position mode"),
    ("cia402", "objects", 0x6087..=0x6088, "IEC 61800-7-201, profile torque mode"),
    ("cia402", "objects", 0x6089..=0x6097, "IEC 61800-7-201, factor group"),
    ("cia402", "objects", 0x6098..=0x609A, "IEC 61800-7-201, homing mode"),
    ("cia402", "objects", 0x60A3..=0x60A4, "IEC 61800-7-201, profile position mode"),
    ("cia402", "objects", 0x60A8..=0x60AB, "IEC 61800-7-201, factor group"),
    ("cia402", "objects", 0x60B0..=0x60B0, "IEC 61800-7-201, cyclic synchronous position mode"),
    ("cia402", "objects", 0x60B1..=0x60B1, "IEC 61800-7-201, cyclic synchronous velocity mode"),
    ("cia402", "objects", 0x60B2..=0x60B2, "IEC 61800-7-201, cyclic synchronous torque mode"),
    ("cia402", "objects", 0x60B8..=0x60BD, "IEC 61800-7-201, touch probe functionality"),
    ("cia402", "objects", 0x60C0..=0x60C4, "IEC 61800-7-201, interpolated position mode"),
    ("cia402", "objects", 0x60C5..=0x60C6, "IEC 61800-7-201, profile position mode"),
    ("cia402", "objects", 0x60D0..=0x60DA, "IEC 61800-7-201, touch probe functionality"),
    ("cia402", "objects", 0x60E0..=0x60E1, "IEC 61800-7-201, profile torque mode"),
    ("cia402", "objects", 0x60E3..=0x60E3, "IEC 61800-7-201, homing mode"),
    ("cia402", "objects", 0x60E4..=0x60EE, "IEC 61800-7-201, factor group"),
    ("cia402", "objects", 0x60F2..=0x60F2, "IEC 61800-7-201, profile position mode"),
    ("cia402", "objects", 0x60F4..=0x60F4, "IEC 61800-7-201, position control function"),
    ("cia402", "objects", 0x60F8..=0x60F8, "IEC 61800-7-201, profile velocity mode"),
    ("cia402", "objects", 0x60FA..=0x60FC, "IEC 61800-7-201, position control function"),
    ("cia402", "objects", 0x60FD..=0x60FE, "IEC 61800-7-201, inputs and outputs"),
    ("cia402", "objects", 0x60FF..=0x60FF, "IEC 61800-7-201, profile velocity mode"),
    ("cia402", "objects", 0x6402..=0x6410, "IEC 61800-7-201, common entries: motor data"),
    ("cia402", "objects", 0x6502..=0x6502, "IEC 61800-7-201, modes of operation"),
    ("cia402", "objects", 0x6503..=0x6510, "IEC 61800-7-201, common entries: drive data"),
    ("cia402", "objects", 0x67FF..=0x67FF, "IEC 61800-7-201, common entries"),
    ("cia402", "words", ANY, "IEC 61800-7-201, at the object whose bits they are"),
    ("cia402", "states", ANY, "IEC 61800-7-201, device control: the finite state automaton"),
    ("cia402", "commands", ANY, "IEC 61800-7-201, device control: command coding"),
    ("cia402", "transitions", ANY, "IEC 61800-7-201, device control: the finite state automaton"),
    ("cia402", "modes", ANY, "IEC 61800-7-201, modes of operation"),
    ("cia402", "errors", ANY, "IEC 61800-7-201, error codes"),
];

/// Where the standards have a thing of a profile; none for what a description says.
pub(super) fn of(entity: Entity<'_>) -> Option<&'static str> {
    let number = keys::range::<u16>(entity.key).map_or(0, |range| *range.start());
    let fits = |(tree, section, numbers, _): &&Clause| {
        *tree == entity.tree.name && *section == entity.section && numbers.contains(&number)
    };
    CLAUSES.iter().find(fits).map(|(.., clause)| *clause)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::explain::tree::Trees;
    use crate::profiles;

    #[test]
    fn all_that_profiles_say_has_its_clause() {
        let trees = Trees::of(profiles::ALL);
        let all: Vec<Entity<'_>> = trees.trees.iter().flat_map(Entity::all).collect();
        assert!(all.len() > 400, "{} things", all.len());
        let without: Vec<String> =
            all.into_iter().filter(|it| of(*it).is_none()).map(|it| it.title()).collect();
        assert!(without.is_empty(), "{without:#?}");
    }
}
