//! What the stack has to know before it looks at objects: mailbox, areas of memory, room for process data.

use serde::Serialize;

use crate::model::{Device, Direction, Pdo, Protocol, Role, SyncManager};

/// The options of a device.
#[derive(Debug, Serialize)]
pub(super) struct Memory {
    foe: bool,
    eoe: bool,
    /// The larger of the mailboxes, since they share their buffers; none if there is no mailbox.
    mailbox: Option<u16>,
    boot_mailbox: Option<u16>,
    areas: Vec<Area>,
    room: Vec<Room>,
}

/// A mailbox, as it is or in Bootstrap.
#[derive(Debug, Serialize)]
struct Area {
    number: u8,
    /// Empty, or `_b` in Bootstrap.
    tail: &'static str,
    address: u16,
    size: u16,
    control: u8,
}

/// What process data of a direction takes.
#[derive(Debug, Serialize)]
struct Room {
    number: u8,
    address: u16,
    control: u8,
    active: u8,
    /// `RX` or `TX`.
    way: &'static str,
    entries: u32,
    bytes: u32,
}

const MAILBOXES: [(u8, Role); 2] = [(0, Role::MailboxOut), (1, Role::MailboxIn)];

pub(super) fn of(device: &Device) -> Memory {
    let speaks = |wanted| device.mailbox.as_ref().is_some_and(|mailbox| mailbox.protocols.contains(&wanted));
    let usual = MAILBOXES.into_iter().filter_map(|(number, role)| {
        let SyncManager { address, size, control, .. } = *device.sync_manager(role)?;
        Some(Area { number, tail: "", address, size, control })
    });
    let boot = device.eeprom.boot_mailbox();
    let in_boot = MAILBOXES.into_iter().zip(boot.into_iter().flatten()).filter_map(
        |((number, role), (address, size))| {
            Some(Area { number, tail: "_b", address, size, control: device.sync_manager(role)?.control })
        },
    );
    let areas: Vec<Area> = usual.chain(in_boot).collect();
    let largest = |tail| areas.iter().filter(|area| area.tail == tail).map(|area| area.size).max();
    Memory {
        foe: speaks(Protocol::Foe),
        eoe: speaks(Protocol::Eoe),
        mailbox: largest(""),
        boot_mailbox: largest("_b").or_else(|| largest("")),
        areas,
        room: [Direction::Rx, Direction::Tx].into_iter().filter_map(|way| room(device, way)).collect(),
    }
}

/// Room for whatever can be assigned: as many PDOs as there are places, each the largest that it can be.
fn room(device: &Device, way: Direction) -> Option<Room> {
    let manager = device.sync_manager(Role::of(way))?;
    let places = usize::from(manager.slots).max(manager.pdos.len());
    let mapped = device.configurations.iter().flat_map(|it| &it.mapping).filter(|pdo| pdo.direction == way);
    let pdos: Vec<&Pdo> = device.pdos_of(way).chain(mapped).collect();
    let most = |size: &dyn Fn(&Pdo) -> u32| {
        let mut sizes: Vec<u32> = pdos.iter().map(|pdo| size(pdo)).collect();
        sizes.sort_unstable_by(|a, b| b.cmp(a));
        sizes.into_iter().take(places).fold(0_u32, u32::saturating_add)
    };
    let entries = |pdo: &Pdo| {
        let has = u32::try_from(pdo.entries.len()).unwrap_or(u32::MAX);
        pdo.max_entries.map_or(has, |most| has.max(most.into()))
    };
    let bytes = |pdo: &Pdo| pdo.max_bytes.map_or(pdo.bytes(), |most| pdo.bytes().max(most.into()));
    let limit = manager.max_size.map_or(u32::MAX, u32::from);
    let (number, label) = if way == Direction::Rx { (2, "RX") } else { (3, "TX") };
    Some(Room {
        number,
        address: manager.address,
        control: manager.control,
        active: u8::from(manager.enable),
        way: label,
        entries: most(&entries),
        bytes: most(&bytes).min(limit),
    })
}
