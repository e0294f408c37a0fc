//! Distributed clocks: the ways to keep time.

use std::collections::BTreeSet;

use super::super::read::{ModeManager, OpMode, Pdo, Signal};
use super::super::report::Report;
use super::super::toml::{Keys, Toml, set};
use super::draft::Block;
use super::sync_managers::{Manager, carries};

/// `[sync-modes]`; the first is the one that masters take.
pub(super) fn sync_modes(modes: &[OpMode], carriers: &Carriers<'_>, report: &mut Report) -> Vec<Block> {
    if modes.iter().all(|mode| mode.assign_activate == 0) {
        for mode in modes {
            let why = "no mode of the file uses the clocks, so that there is none to choose";
            report.lose(mode.at, 2, format!("OpMode `{}`", mode.name), why);
        }
        return Vec::new();
    }
    let mut blocks: Vec<Block> = Vec::new();
    let mut names = BTreeSet::new();
    for (number, mode) in (1..).zip(modes) {
        let name = match mode.name.as_str() {
            "" => {
                let name = format!("Mode {number}");
                report.guess(mode.at, "the name of an OpMode", format!("it has none; `{name}` is taken"));
                name
            }
            name => name.to_owned(),
        };
        if !names.insert(name.clone()) {
            report.lose(mode.at, 2, format!("OpMode `{name}`"), "there is one of this name already");
            continue;
        }
        let first = blocks.is_empty();
        blocks.push(block(mode, name, first, carriers, report));
    }
    blocks
}

fn block(mode: &OpMode, name: String, first: bool, carriers: &Carriers<'_>, report: &mut Report) -> Block {
    let mut keys = Keys::new();
    set(&mut keys, "name", Toml::text(mode.description.as_ref().unwrap_or(&name)));
    set(&mut keys, "assign-activate", Toml::Hex(mode.assign_activate.into(), 3));
    if first {
        set(&mut keys, "default", Toml::Bool(true));
    }
    for (key, signal) in [("sync0", &mode.sync0), ("sync1", &mode.sync1)] {
        if let Some(signal) = signal {
            set(&mut keys, key, Toml::Table(self::signal(signal, key, report)));
        }
    }
    let managers: Keys =
        mode.managers.iter().filter_map(|manager| carriers.described(manager, report)).collect();
    if !managers.is_empty() {
        set(&mut keys, "managers", Toml::Table(managers));
    }
    Block::new("sync-modes", Some(name), keys)
}

/// The sync managers and PDOs that a mode can name.
#[derive(Debug, Clone, Copy)]
pub(super) struct Carriers<'c> {
    pub(super) managers: &'c [Manager<'c>],
    /// What the master sends, and what the device sends.
    pub(super) pdos: [&'c [&'c Pdo]; 2],
}

impl<'c> Carriers<'c> {
    /// The PDOs of the direction of a sync manager.
    pub(super) fn carried(&self, number: u8) -> &'c [&'c Pdo] {
        let manager = self.managers.iter().find(|it| it.number == number);
        manager.map_or(&[], |manager| carries(manager, self.pdos))
    }

    /// What a mode says of a sync manager.
    fn described(&self, said: &ModeManager, report: &mut Report) -> Option<(String, Toml)> {
        let facts = 1 + usize::from(said.sync_type.is_some()) + said.pdos.len();
        let Some(manager) = self.managers.iter().find(|it| it.number == said.number) else {
            let why = "there is no such sync manager";
            report.lose(said.at, facts, format!("Sm {} of an OpMode", said.number), why);
            return None;
        };
        let known = carries(manager, self.pdos);
        let mut pdos = Vec::new();
        for (index, factor) in &said.pdos {
            let text = Toml::text(format!("0x{index:04X}"));
            match factor {
                _ if !known.iter().any(|pdo| pdo.index == *index) => {
                    let what = format!("PDO 0x{index:04X} in an OpMode");
                    let lost = 1 + usize::from(factor.is_some());
                    report.lose(said.at, lost, what, "it is none that the sync manager carries");
                }
                None => pdos.push(text),
                Some(factor) => pdos.push(Toml::Table(vec![
                    ("pdo".to_owned(), text),
                    ("oversampling".to_owned(), Toml::Integer((*factor).into())),
                ])),
            }
        }
        let mut keys = Keys::new();
        if !pdos.is_empty() {
            set(&mut keys, "pdos", Toml::List(pdos));
        }
        if let Some(kind) = said.sync_type {
            set(&mut keys, "sync-type", Toml::Integer(kind.into()));
        }
        Some((manager.key.clone(), Toml::Table(keys)))
    }
}

fn signal(signal: &Signal, name: &str, report: &mut Report) -> Keys {
    let mut keys = Keys::new();
    match u64::try_from(signal.cycle) {
        Ok(0) => {
            if let Some(factor) = signal.factor.filter(|factor| *factor != 1) {
                set(&mut keys, "cycles", Toml::Integer(factor.into()));
            }
        }
        Ok(_) => {
            set(&mut keys, "period", Toml::text(time(signal.cycle)));
            if signal.factor.is_some() {
                let why = "it has a period of its own, of which no cycles are counted";
                report.lose(signal.at, 1, format!("the factor of {name} of an OpMode"), why);
            }
        }
        Err(_) => {
            report.lose(signal.at, 1, format!("the period of {name} of an OpMode"), "it is negative");
        }
    }
    if signal.shift != 0 {
        set(&mut keys, "shift", Toml::text(time(signal.shift)));
    }
    if let Some(factor) = signal.shift_factor.filter(|factor| *factor != 0) {
        set(&mut keys, "shift-cycles", Toml::Integer(factor.into()));
    }
    if signal.of_inputs {
        set(&mut keys, "of-inputs", Toml::Bool(true));
    }
    keys
}

/// A time in the largest unit in which it is a whole number.
pub(super) fn time(nanoseconds: i64) -> String {
    let units = [("s", 1_000_000_000), ("ms", 1_000_000), ("us", 1_000)];
    let unit = units.into_iter().find(|(_, unit)| nanoseconds % unit == 0);
    unit.map_or_else(|| format!("{nanoseconds} ns"), |(name, unit)| format!("{} {name}", nanoseconds / unit))
}
