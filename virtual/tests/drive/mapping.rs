//! Every mapping and every assignment that a dictionary lets a master make, write by write.

use devc::model::{Address, Device, Direction, Entry, Index, Pdo, Role};
use devc_runtime::sdo::AbortCode;

use crate::bench::{Bench, PRE_OP};
use crate::shared::all;

/// CiA 301, "PDO mapping parameter" and "Abort SDO transfer": an object that cannot be mapped, and one that is read only.
const UNMAPPABLE: AbortCode = AbortCode(0x0604_0041);
const READ_ONLY: AbortCode = AbortCode(0x0601_0002);

fn at(index: Index, subindex: u8) -> Address {
    Address { index, subindex }
}

fn pre_operational(device: &'static Device) -> Bench {
    let mut bench = Bench::new(device, None);
    bench.request(PRE_OP).expect("nothing is wrong");
    bench
}

fn is_mappable(entry: &Entry, way: Direction) -> bool {
    match way {
        Direction::Rx => entry.pdo.rx(),
        Direction::Tx => entry.pdo.tx(),
    }
}

/// What a mapping object holds for an entry (CiA 301, "PDO mapping parameter").
fn word(entry: &Entry) -> [u8; 4] {
    let Address { index, subindex } = entry.address;
    (u32::from(index.0) << 16 | u32::from(subindex) << 8 | entry.data_type.bits()).to_le_bytes()
}

/// Maps entries as ETG.1020 has it: the number is cleared, the entries are written, and then their number.
fn map(bench: &mut Bench, pdo: &Pdo, entries: &[&Entry]) -> Result<(), AbortCode> {
    bench.download(at(pdo.index, 0), &[0])?;
    for (subindex, entry) in (1..).zip(entries) {
        bench.download(at(pdo.index, subindex), &word(entry))?;
    }
    bench.download(at(pdo.index, 0), &[entries.len() as u8])
}

/// Entries in groups that a PDO takes at once.
fn groups<'e>(bench: &Bench, pdo: &Pdo, entries: &[&'e Entry]) -> Vec<Vec<&'e Entry>> {
    let object = bench.device.object(pdo.index).expect("each PDO has one");
    let (most, bytes) = (object.entries.len() - 1, pdo.max_bytes.map_or(u32::MAX, u32::from));
    let mut groups: Vec<Vec<&Entry>> = Vec::new();
    for entry in entries {
        let bits = |group: &[&Entry]| group.iter().map(|it| it.data_type.bits()).sum::<u32>();
        let has_room = |group: &&mut Vec<&Entry>| {
            group.len() < most && (bits(group) + entry.data_type.bits()).div_ceil(8) <= bytes
        };
        match groups.last_mut().filter(has_room) {
            Some(group) => group.push(entry),
            None => groups.push(vec![entry]),
        }
    }
    groups
}

#[test]
fn each_entry_can_be_mapped_where_the_dictionary_says_so_and_nowhere_else() {
    let (mut mapped, mut refused) = (0, 0);
    for device in all() {
        let is_free = |pdo: &&Pdo| !pdo.fixed && device.mailbox.as_ref().is_some_and(|it| it.pdo_config);
        for pdo in device.pdos.iter().filter(is_free) {
            let mut bench = pre_operational(device);
            let all = device.objects.iter().filter(|object| object.functional).flat_map(|it| &it.entries);
            let (fit, unfit): (Vec<_>, Vec<_>) = all.partition(|entry| is_mappable(entry, pdo.direction));
            for group in groups(&bench, pdo, &fit) {
                let name = format!("{} {}", device.name, pdo.index);
                assert_eq!(map(&mut bench, pdo, &group), Ok(()), "{name}: {group:#?}");
                mapped += group.len();
            }
            for entry in unfit {
                let name = format!("{} {}: {}", device.name, pdo.index, entry.address);
                assert_eq!(map(&mut bench, pdo, &[entry]), Err(UNMAPPABLE), "{name}");
                refused += 1;
            }
        }
    }
    assert!(mapped > 300 && refused > 2000, "{mapped} mapped, {refused} refused");
}

#[test]
fn a_fixed_mapping_stays() {
    let mut fixed = 0;
    for device in all() {
        let mut bench = pre_operational(device);
        let can_map = device.mailbox.as_ref().is_some_and(|mailbox| mailbox.pdo_config);
        for pdo in device.pdos.iter().filter(|pdo| pdo.fixed || !can_map) {
            let refused = bench.download(at(pdo.index, 0), &[0]);
            assert_eq!(refused, Err(READ_ONLY), "{} {}", device.name, pdo.index);
            fixed += 1;
        }
    }
    assert!(fixed > 50, "{fixed} are fixed");
}

#[test]
fn each_pdo_can_be_assigned_alone() {
    let mut assigned = 0;
    for device in all().filter(|it| it.mailbox.as_ref().is_some_and(|mailbox| mailbox.pdo_assign)) {
        for pdo in &device.pdos {
            let others = |it: &&Pdo| it.direction == pdo.direction && it.mandatory && it.index != pdo.index;
            if device.pdos.iter().any(|it| others(&it)) {
                continue;
            }
            let mut bench = pre_operational(device);
            let manager = device.sync_manager(Role::of(pdo.direction)).expect("there is one");
            let object = manager.assignment();
            let writes = [(0, vec![0]), (1, pdo.index.0.to_le_bytes().to_vec()), (0, vec![1])];
            for (subindex, data) in writes {
                let written = bench.download(at(object, subindex), &data);
                assert_eq!(written, Ok(()), "{}: {} in {object}", device.name, pdo.index);
            }
            assigned += 1;
        }
    }
    assert!(assigned > 30, "{assigned} were assigned");
}
