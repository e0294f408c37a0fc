//! What the device is, its mapping units, sync managers and clocks.

use super::strings::Strings;
use super::{Category, ERASED};
use crate::model::{Device, Mailbox, Protocol, Role, SyncManager, SyncMode};

/// Types of categories.
const GENERAL: u16 = 30;
const MAPPING_UNITS: u16 = 40;
const SYNC_MANAGERS: u16 = 41;
const CLOCKS: u16 = 60;

/// Names, what the mailbox can do, and the ports.
pub(super) fn general(device: &Device, strings: &mut Strings) -> Option<Category> {
    // SOEM calls a device by the first string, whatever is said here of strings; vendors' images have the order code there
    let order = strings.number(&device.type_name);
    let group = strings.number(&device.group);
    let name = strings.number(&device.name);
    let mailbox = device.mailbox.as_ref();
    let speaks = |protocol| mailbox.is_some_and(|mailbox| mailbox.protocols.contains(&protocol));
    let axes = u8::try_from(device.axes.len()).unwrap_or(u8::MAX);
    let drives = if device.profile.is_some() { axes } else { 0 };
    let mut data = vec![group, 0, order, name, 0];
    data.push(mailbox.filter(|_| speaks(Protocol::Coe)).map_or(0, coe));
    data.push(u8::from(speaks(Protocol::Foe)));
    data.push(u8::from(speaks(Protocol::Eoe)));
    data.push(if speaks(Protocol::Soe) { axes } else { 0 });
    data.extend([drives, 0, flags(device)]);
    data.extend(current(device).to_le_bytes());
    data.extend([group, 0]);
    data.extend(ports(&device.physics).to_le_bytes());
    data.extend(device.identity.id_address.unwrap_or(0).to_le_bytes());
    data.resize(32, 0);
    Category::of(GENERAL, data, 0)
}

/// What CoE can do.
fn coe(mailbox: &Mailbox) -> u8 {
    const SDO: u8 = 0x01;
    let abilities = [
        (mailbox.sdo_info, 0x02),
        (mailbox.pdo_assign, 0x04),
        (mailbox.pdo_config, 0x08),
        (mailbox.pdo_upload == Some(true), 0x10),
        (mailbox.complete_access, 0x20),
    ];
    abilities.into_iter().filter(|(able, _)| *able).fold(SDO, |bits, (_, bit)| bits | bit)
}

/// That there is no LRW, that mail is acknowledged, as the ESI says of every mailbox, and where a master finds the number that
/// people set.
fn flags(device: &Device) -> u8 {
    let flags = [
        (device.no_lrw, 0x02),
        (device.mailbox.is_some(), 0x04),
        (device.identity.requested_id, 0x08),
        (device.identity.id_address.is_some(), 0x10),
    ];
    flags.into_iter().filter(|(holds, _)| *holds).fold(0, |flags, (_, flag)| flags | flag)
}

/// The current from the E-bus, as far as a word can hold it.
fn current(device: &Device) -> i16 {
    let most = (i32::from(i16::MIN), i32::from(i16::MAX));
    i16::try_from(device.ebus_current.unwrap_or(0).clamp(most.0, most.1)).unwrap_or(0)
}

/// Four bits for each port, the first lowest.
fn ports(physics: &str) -> u16 {
    let kind = |letter: char| match letter {
        'Y' => 1,
        'K' => 3,
        'H' => 4,
        _ => 0,
    };
    let ports = physics.chars().zip([0, 4, 8, 12]);
    ports.fold(0, |ports, (letter, shift)| ports | kind(letter) << shift)
}

/// What each mapping unit of the controller is for.
pub(super) fn mapping_units(device: &Device) -> Option<Category> {
    let unit = |manager: &SyncManager| match manager.role {
        Role::Outputs => 1,
        Role::Inputs => 2,
        Role::MailboxIn | Role::MailboxOut => 3,
    };
    Category::of(MAPPING_UNITS, device.mapping_units().map(unit).collect(), ERASED)
}

/// Where the sync managers are, by number.
pub(super) fn sync_managers(device: &Device) -> Option<Category> {
    let data = device.sync_managers.iter().flat_map(|manager| {
        let [start, length] = [manager.address, manager.size].map(u16::to_le_bytes);
        const STATUS: u8 = 0;
        let enable = u8::from(manager.enable) | u8::from(manager.op_only) << 3;
        start.into_iter().chain(length).chain([manager.control, STATUS, enable, manager.role.kind()])
    });
    Category::of(SYNC_MANAGERS, data.collect(), 0)
}

/// The ways to keep time, the default first.
pub(super) fn clocks(device: &Device, strings: &mut Strings) -> Option<Category> {
    let data = device.clock_modes().iter().flat_map(|mode| clock(mode, strings));
    Category::of(CLOCKS, data.collect(), 0)
}

/// A period of 0 ns leaves it to the factor. The second signal has no period of its own here.
fn clock(mode: &SyncMode, strings: &mut Strings) -> Vec<u8> {
    let (sync0, sync1) = (mode.sync0.as_ref(), mode.sync1.as_ref());
    let period = sync0.and_then(|signal| signal.period);
    let factor = |cycles: i32| i16::try_from(cycles).unwrap_or(0).to_le_bytes();
    let shifts = [sync0, sync1].map(|signal| signal.map_or(0, |signal| signal.shift.0));
    let mut data = Vec::from(period.map_or(0, |time| u32::try_from(time.0).unwrap_or(0)).to_le_bytes());
    data.extend(shifts.into_iter().flat_map(|shift| i32::try_from(shift).unwrap_or(0).to_le_bytes()));
    data.extend(factor(sync1.map_or(0, |signal| signal.cycles)));
    data.extend(mode.assign_activate.to_le_bytes());
    data.extend(factor(sync0.filter(|_| period.is_none()).map_or(0, |signal| signal.cycles)));
    data.extend([strings.number(&mode.id), strings.number(&mode.name)]);
    data.resize(24, 0);
    data
}
