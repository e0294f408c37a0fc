//! Distributed clocks: the ways to keep time.

use std::collections::BTreeSet;

use super::super::read::{OpMode, Signal};
use super::super::report::Report;
use super::super::toml::{Keys, Toml, set};
use super::draft::Block;

/// `[sync-modes]`; the first is the one that masters take.
pub(super) fn sync_modes(modes: &[OpMode], report: &mut Report) -> Vec<Block> {
    if modes.iter().all(|mode| mode.assign_activate == 0) {
        for mode in modes {
            let why = "no mode of the file uses the clocks, so that there is none to choose";
            report.lose(mode.at, 2, format!("OpMode `{}`", mode.name), why);
        }
        return Vec::new();
    }
    let mut blocks: Vec<Block> = Vec::new();
    let mut names = BTreeSet::new();
    for mode in modes {
        if !names.insert(&mode.name) {
            report.lose(mode.at, 2, format!("OpMode `{}`", mode.name), "there is one of this name already");
            continue;
        }
        let first = blocks.is_empty();
        blocks.push(block(mode, first, report));
    }
    blocks
}

fn block(mode: &OpMode, first: bool, report: &mut Report) -> Block {
    let mut keys = Keys::new();
    set(&mut keys, "name", Toml::text(mode.description.as_ref().unwrap_or(&mode.name)));
    set(&mut keys, "assign-activate", Toml::Hex(mode.assign_activate.into(), 3));
    if first {
        set(&mut keys, "default", Toml::Bool(true));
    }
    for (name, signal) in [("sync0", &mode.sync0), ("sync1", &mode.sync1)] {
        if let Some(signal) = signal {
            set(&mut keys, name, Toml::Table(self::signal(signal, name, report)));
        }
    }
    Block::new("sync-modes", Some(mode.name.clone()), keys)
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
fn time(nanoseconds: i64) -> String {
    let units = [("s", 1_000_000_000), ("ms", 1_000_000), ("us", 1_000)];
    let unit = units.into_iter().find(|(_, unit)| nanoseconds % unit == 0);
    unit.map_or_else(|| format!("{nanoseconds} ns"), |(name, unit)| format!("{} {name}", nanoseconds / unit))
}
