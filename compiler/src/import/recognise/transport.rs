//! Sync managers and the mailbox.

use std::collections::BTreeSet;

use super::super::read::{At, Mailbox, Pdo, Sm};
use super::super::report::Report;
use super::super::toml::{Keys, Toml, set};
use super::draft::Block;

/// What a sync manager is for, by the order of the usual ones.
const ROLES: [(&str, &str, u8); 4] = [
    ("mailbox-out", "mboxout", 0x26),
    ("mailbox-in", "mboxin", 0x22),
    ("outputs", "outputs", 0x64),
    ("inputs", "inputs", 0x20),
];

/// The tables of the sync managers, with the PDOs that each carries at start-up in the order of the file.
/// `followers` are PDOs that come with that of the first axis.
pub(super) fn sync_managers(
    managers: &[Sm],
    [rx, tx]: [&[&Pdo]; 2],
    followers: &BTreeSet<u16>,
    slots: [usize; 2],
    report: &mut Report,
) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    for (number, manager) in (0..=u8::MAX).zip(managers) {
        let Some(role) = role(manager, report) else {
            let why = format!("`{}` is none of the four roles", manager.name);
            report.lose(manager.at, facts(manager), format!("Sm {number}"), why);
            continue;
        };
        let (key, _, usual) = role;
        if blocks.iter().any(|block| block.key.as_deref() == Some(key)) {
            report.lose(
                manager.at,
                facts(manager),
                format!("Sm {number}"),
                format!("there are {key} already"),
            );
            continue;
        }
        let carried = match key {
            "outputs" => rx,
            "inputs" => tx,
            _ => &[],
        };
        let pdos: Vec<&Pdo> = carried.iter().copied().filter(|pdo| pdo.sm == Some(number)).collect();
        let slots = slots.get(usize::from(key == "inputs")).copied().filter(|_| !key.starts_with("mailbox"));
        let slots = slots.filter(|slots| *slots > pdos.len());
        let mut block = block(manager, key, usual, &pdos, report);
        if let Some(Toml::List(assigned)) =
            block.keys.iter_mut().find(|(key, _)| key == "pdos").map(|(_, it)| it)
        {
            let named = |index: &u16| Toml::text(format!("0x{index:04X}"));
            let followers: Vec<Toml> = followers.iter().map(named).collect();
            assigned.retain(|pdo| !followers.contains(pdo));
        }
        if let Some(slots) = slots {
            set(&mut block.keys, "slots", Toml::Integer(slots.min(255) as i128));
        }
        blocks.push(block);
    }
    for pdo in rx.iter().chain(tx).filter(|pdo| !followers.contains(&pdo.index)) {
        let text = format!("0x{:04X}", pdo.index);
        let assigned = |block: &Block| block.keys.iter().any(|(_, value)| lists(value, &text));
        if let Some(number) = pdo.sm.filter(|_| !blocks.iter().any(assigned)) {
            report.lose(
                pdo.at,
                1,
                format!("Sm of PDO {text}"),
                format!("sync manager {number} does not carry its direction"),
            );
        }
    }
    blocks
}

/// Reports mapping units that are not those that follow from the sync managers, in their usual order.
pub(super) fn fmmus(fmmus: &[(String, At)], managers: &[Block], report: &mut Report) {
    let usual = [("outputs", "outputs"), ("inputs", "inputs"), ("mailbox-in", "mboxstate")];
    let has = |role: &str| managers.iter().any(|block| block.key.as_deref() == Some(role));
    let mut made = usual.into_iter().filter(|(role, _)| has(role)).map(|(_, name)| name);
    for (name, at) in fmmus {
        if made.by_ref().all(|made| !name.eq_ignore_ascii_case(made)) {
            report.lose(*at, 1, format!("Fmmu `{name}`"), "mapping units follow from the sync managers");
        }
    }
}

fn lists(value: &Toml, text: &str) -> bool {
    matches!(value, Toml::List(items) if items.iter().any(|item| matches!(item, Toml::Text(item) if item == text)))
}

fn facts(manager: &Sm) -> usize {
    let said = [
        !manager.name.is_empty(),
        manager.address.is_some(),
        manager.default_size.is_some(),
        manager.max_size.is_some(),
        manager.control.is_some(),
        manager.enable.is_some(),
    ];
    said.into_iter().filter(|said| *said).count()
}

/// The role by its name; without one by the direction and the buffers of the control byte.
fn role(manager: &Sm, report: &mut Report) -> Option<(&'static str, &'static str, u8)> {
    let name = manager.name.to_ascii_lowercase();
    if !name.is_empty() {
        return ROLES.into_iter().find(|(_, known, _)| *known == name);
    }
    let control = manager.control?;
    let place = usize::from(control & 0b11 == 0) * 2 + usize::from(control & 0b1100 == 0);
    let role = ROLES.get(place).copied()?;
    report.guess(
        manager.at,
        format!("the role {} of a sync manager", role.0),
        "it has none; its control byte tells it",
    );
    Some(role)
}

fn block(manager: &Sm, key: &'static str, usual: u8, pdos: &[&Pdo], report: &mut Report) -> Block {
    let mut keys = Keys::new();
    let address = manager.address.unwrap_or_else(|| {
        report.guess(manager.at, format!("the address of {key}"), "the file has none; 0x1000 is taken");
        0x1000
    });
    set(&mut keys, "address", Toml::Hex(address.into(), 4));
    let bits: u32 = pdos.iter().flat_map(|pdo| &pdo.entries).map(|entry| u32::from(entry.bits)).sum();
    let image = bits.div_ceil(8);
    if let Some(size) =
        manager.default_size.filter(|size| key.starts_with("mailbox") || u32::from(*size) != image)
    {
        set(&mut keys, "size", Toml::Integer(size.into()));
    }
    if let Some(size) = manager.max_size {
        set(&mut keys, "max-size", Toml::Integer(size.into()));
    }
    if let Some(control) = manager.control.filter(|control| *control != usual) {
        set(&mut keys, "control", Toml::Hex(control.into(), 2));
    }
    let size = manager.default_size.map_or(image, u32::from);
    if manager.enable.is_some_and(|enable| enable != (size > 0)) {
        let why = "a sync manager is on if it has something to carry";
        report.lose(manager.at, 1, format!("Enable of {key}"), why);
    }
    if !pdos.is_empty() {
        set(&mut keys, "pdos", Toml::texts(pdos.iter().map(|pdo| format!("0x{:04X}", pdo.index))));
    }
    Block::new("sync-managers", Some(key.to_owned()), keys)
}

/// `[mailbox]`.
pub(super) fn mailbox(mailbox: &Mailbox, report: &mut Report) -> Option<Block> {
    if mailbox.protocols.is_empty() {
        report.lose(mailbox.at, 0, "Mailbox", "it has none of the protocols that descriptions know");
        return None;
    }
    let mut keys = Keys::new();
    let mut protocols = mailbox.protocols.clone();
    protocols.dedup();
    set(&mut keys, "protocols", Toml::texts(protocols));
    let flags = [
        ("sdo-info", mailbox.sdo_info),
        ("pdo-assign", mailbox.pdo_assign),
        ("pdo-config", mailbox.pdo_config),
        ("complete-access", mailbox.complete_access),
        ("segmented", mailbox.segmented),
    ];
    for (name, value) in flags.into_iter().filter(|_| mailbox.protocols.iter().any(|it| it == "CoE")) {
        set(&mut keys, name, Toml::Bool(value));
    }
    for command in &mailbox.commands {
        let what = format!(
            "InitCmd 0x{:04X}:{:02X} in {}",
            command.index,
            command.subindex,
            command.transitions.join(", ")
        );
        let data: String = command.data.iter().map(|byte| format!("{byte:02X}")).collect();
        report.lose(
            command.at,
            command.facts,
            what,
            format!("descriptions have no start-up commands; it writes {data}"),
        );
    }
    Some(Block::new("mailbox", None, keys))
}
