//! Sync managers and mapping units.

use std::collections::BTreeSet;

use super::super::read::{At, Fmmu, Pdo, Sm};
use super::super::report::Report;
use super::super::toml::{Keys, Toml, set};
use super::draft::Block;
use crate::model::Role;

/// A sync manager with what it is for.
#[derive(Debug)]
pub(super) struct Manager<'m> {
    /// Its place among the sync managers.
    pub(super) number: u8,
    pub(super) role: Role,
    /// The word for it.
    pub(super) key: String,
    manager: &'m Sm,
}

/// The sync managers in the order of the file, each with a word of its own.
pub(super) fn managers<'m>(managers: &'m [Sm], report: &mut Report) -> Vec<Manager<'m>> {
    let mut named: Vec<Manager<'m>> = Vec::new();
    for (number, manager) in (0..=u8::MAX).zip(managers) {
        let role = role(manager, number, report);
        let before = named.iter().filter(|other| other.role == role).count();
        let key = if before == 0 { role.key().to_owned() } else { format!("{}-{}", role.key(), before + 1) };
        named.push(Manager { number, role, key, manager });
    }
    named
}

/// The role by its name; without a usual one by the direction and the buffers of the control byte, else by its place.
fn role(manager: &Sm, number: u8, report: &mut Report) -> Role {
    let key = |role: &Role| role.key().replace("mailbox-", "mbox");
    let name = manager.name.to_ascii_lowercase();
    if let Some(role) = Role::ALL.into_iter().find(|role| key(role) == name) {
        return role;
    }
    let by_control = manager.control.and_then(|control| {
        let place = usize::from(control & 0b11 == 0) * 2 + usize::from(control & 0b1100 == 0);
        Role::ALL.get(place).copied()
    });
    let by_place = Role::ALL.get(usize::from(number.min(3))).copied().unwrap_or(Role::Inputs);
    let role = by_control.unwrap_or(by_place);
    let what = format!("the role {} of a sync manager", role.key());
    let from = if by_control.is_some() { "its control byte tells it" } else { "its place tells it" };
    if name.is_empty() {
        report.guess(manager.at, what, format!("it has none; {from}"));
    } else {
        report.guess(manager.at, what, format!("it is called `{}`; {from}", manager.name));
        let why = "descriptions call sync managers by their roles";
        report.lose(manager.at, 1, format!("the name of Sm {number}"), why);
    }
    role
}

/// The PDOs that a sync manager carries at start-up, in the order of the file.
pub(super) fn carried<'p>(manager: &Manager<'_>, [rx, tx]: [&[&'p Pdo]; 2]) -> Vec<&'p Pdo> {
    carries(manager, [rx, tx]).iter().copied().filter(|pdo| pdo.sm == Some(manager.number)).collect()
}

/// The PDOs of the direction of a sync manager.
pub(super) fn carries<'l, 'p>(manager: &Manager<'_>, [rx, tx]: [&'l [&'p Pdo]; 2]) -> &'l [&'p Pdo] {
    match manager.role {
        Role::Outputs => rx,
        Role::Inputs => tx,
        Role::MailboxOut | Role::MailboxIn => &[],
    }
}

/// The tables of the sync managers. `followers` are PDOs that come with that of the first axis, and `slots` says how many
/// PDOs an assignment object has room for.
pub(super) fn blocks(
    managers: &[Manager<'_>],
    pdos: [&[&Pdo]; 2],
    followers: &BTreeSet<u16>,
    slots: impl Fn(u8) -> usize,
    report: &mut Report,
) -> Vec<Block> {
    let is_usual = managers.is_sorted_by_key(|manager| manager.role);
    let outputs = managers.iter().filter(|manager| manager.role == Role::Outputs);
    let outputs = outputs.map(|manager| image(&self::carried(manager, pdos))).sum();
    let mut blocks = Vec::new();
    let mut assigned = BTreeSet::new();
    for manager in managers {
        let carried = carried(manager, pdos);
        assigned.extend(carried.iter().map(|pdo| pdo.index));
        let mut keys = keys(manager, is_usual, (&carried, outputs), report);
        let named = carried.iter().filter(|pdo| !followers.contains(&pdo.index));
        let named: Vec<String> = named.map(|pdo| format!("0x{:04X}", pdo.index)).collect();
        if !named.is_empty() {
            set(&mut keys, "pdos", Toml::texts(named));
        }
        let room = slots(manager.number);
        if manager.role.is_process_data() && room > carried.len() {
            set(&mut keys, "slots", Toml::Integer(room.min(255) as i128));
        }
        blocks.push(Block::new("sync-managers", Some(manager.key.clone()), keys));
    }
    for pdo in pdos.into_iter().flatten().filter(|pdo| !assigned.contains(&pdo.index)) {
        if let Some(number) = pdo.sm {
            let why = format!("sync manager {number} does not carry its direction");
            report.lose(pdo.at, 1, format!("Sm of PDO 0x{:04X}", pdo.index), why);
        }
    }
    blocks
}

/// The bytes of PDOs one behind the other.
fn image(pdos: &[&Pdo]) -> u32 {
    let bits: u32 = pdos.iter().flat_map(|pdo| &pdo.entries).map(|entry| u32::from(entry.bits)).sum();
    bits.div_ceil(8)
}

/// The bytes of a mailbox of which a file does not say how long it is.
const MAILBOX: u16 = 128;

/// Where an area lies if a file does not say it: mailboxes from the first byte of the memory on, then outputs and inputs with
/// three buffers each.
fn usual_address(role: Role, outputs: u32) -> u16 {
    let first: u16 = 0x1000;
    match role {
        Role::MailboxOut => first,
        Role::MailboxIn => first + MAILBOX,
        Role::Outputs => first + 2 * MAILBOX,
        Role::Inputs => {
            let behind = outputs.saturating_mul(3).next_multiple_of(u32::from(MAILBOX));
            u16::try_from(behind).unwrap_or(MAILBOX).saturating_add(first + 2 * MAILBOX)
        }
    }
}

/// The length of the area; a mailbox has to have one.
fn size(manager: &Sm, role: Role, key: &str, report: &mut Report) -> Option<u16> {
    if manager.default_size.is_none() && manager.max_size.is_none() && !role.is_process_data() {
        let why = format!("the file has none; {MAILBOX} bytes are taken");
        report.guess(manager.at, format!("the size of {key}"), why);
        return Some(MAILBOX);
    }
    manager.default_size
}

/// All that a sync manager says but for its PDOs.
fn keys(
    manager: &Manager<'_>,
    is_usual: bool,
    (carried, outputs): (&[&Pdo], u32),
    report: &mut Report,
) -> Keys {
    let Manager { number, role, key, manager } = manager;
    let mut keys = Keys::new();
    if key != role.key() {
        set(&mut keys, "role", Toml::text(role.key()));
    }
    if !is_usual {
        set(&mut keys, "number", Toml::Integer((*number).into()));
    }
    let address = manager.address.unwrap_or_else(|| {
        let address = usual_address(*role, outputs);
        let why = format!("the file has none; 0x{address:04X} is taken");
        report.guess(manager.at, format!("the address of {key}"), why);
        address
    });
    set(&mut keys, "address", Toml::Hex(address.into(), 4));
    let image = image(carried);
    let is_own = |size: &u16| !role.is_process_data() || u32::from(*size) != image;
    let size = size(manager, *role, key, report);
    let sizes =
        [("size", size.filter(is_own)), ("min-size", manager.min_size), ("max-size", manager.max_size)];
    for (name, size) in sizes.into_iter().filter_map(|(name, size)| Some((name, size?))) {
        set(&mut keys, name, Toml::Integer(size.into()));
    }
    if let Some(control) = manager.control.filter(|control| *control != role.usual_control()) {
        set(&mut keys, "control", Toml::Hex(control.into(), 2));
    }
    let size = size.map_or(image, u32::from);
    if let Some(enable) = manager.enable.filter(|enable| *enable != (size > 0)) {
        set(&mut keys, "enable", Toml::Bool(enable));
    }
    if manager.op_only {
        set(&mut keys, "op-only", Toml::Bool(true));
    }
    if manager.r#virtual {
        set(&mut keys, "virtual", Toml::Bool(true));
    }
    keys
}

/// Reports mapping units that are not those that follow from the sync managers, in their usual order.
pub(super) fn fmmus(fmmus: &[Fmmu], managers: &[Manager<'_>], pdos: [&[&Pdo]; 2], report: &mut Report) {
    let usual = [(Role::Outputs, "outputs"), (Role::Inputs, "inputs"), (Role::MailboxIn, "mboxstate")];
    let of_role = |(role, name)| managers.iter().filter(move |it| it.role == role).map(move |it| (name, it));
    let made: Vec<(&str, &Manager<'_>)> = usual.into_iter().flat_map(of_role).collect();
    let mut left = made.as_slice();
    let unsaid = |units: &[(&str, &Manager<'_>)], at: At, report: &mut Report| {
        for (name, _) in units {
            let why = "the file has none here; mapping units follow from the sync managers";
            report.guess(at, format!("Fmmu `{name}`"), why);
        }
    };
    for Fmmu { at, name, sm, su } in fmmus {
        let place = left.iter().position(|(made, _)| name.eq_ignore_ascii_case(made));
        let (skipped, rest) = left.split_at(place.unwrap_or(0));
        unsaid(skipped, *at, report);
        let unit = rest.first().filter(|_| place.is_some());
        left = rest.get(usize::from(place.is_some())..).unwrap_or_default();
        let facts = match unit {
            None => usize::from(!name.is_empty()) + usize::from(sm.is_some()),
            Some((_, manager)) => usize::from(sm.is_some_and(|sm| sm != manager.number)),
        };
        if facts > 0 {
            report.lose(*at, facts, format!("Fmmu `{name}`"), "mapping units follow from the sync managers");
        }
        let follows = |number: u8| {
            let carried = unit.map(|(_, manager)| carried(manager, pdos)).unwrap_or_default();
            !carried.is_empty() && carried.iter().all(|pdo| pdo.su == Some(number))
        };
        if su.is_some_and(|number| !follows(number)) {
            report.lose(*at, 1, "Fmmu/@Su", "the PDOs that it maps are not all of this sync unit");
        }
    }
    if let Some(last) = fmmus.last() {
        unsaid(left, last.at, report);
    }
}
