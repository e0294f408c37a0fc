//! What a master sets up of a device: what is by default, and each configuration.

use serde::Serialize;

use crate::emit::escape::prose;
use crate::emit::identifier::{Claimed, snake};
use crate::model::{Configuration, Device, Index, Pdo, Role, SdoWrite, SyncManager};

/// A way to set a device up.
#[derive(Debug, Serialize)]
pub(super) struct Setup {
    /// What stands behind the name of the device in each name.
    tail: String,
    title: String,
    managers: Vec<Manager>,
    /// SDOs of 1, 2 and 4 bytes are numbers, others bytes.
    sdos: Vec<Sdo>,
    /// How many writes belong to a change of state in which the master makes none.
    later: usize,
}

/// A sync manager with what it carries.
#[derive(Debug, Serialize)]
struct Manager {
    number: u8,
    is_output: bool,
    is_process_data: bool,
    watchdog: bool,
    pdos: Vec<Mapping>,
}

/// A PDO with its entries: index, subindex, bits.
#[derive(Debug, Serialize)]
struct Mapping {
    index: u16,
    title: String,
    entries: Vec<(u16, u8, u32)>,
}

/// A write through the mailbox.
#[derive(Debug, Serialize)]
struct Sdo {
    index: u16,
    subindex: u8,
    bits: usize,
    value: u64,
    data: Vec<u8>,
    title: String,
}

/// The changes of state before which the master writes.
const EARLY: [&str; 2] = ["IP", "PS"];

/// The default first, which is the default configuration if there is one.
pub(super) fn setups(device: &Device) -> Vec<Setup> {
    let default = device.configurations.iter().find(|configuration| configuration.default);
    let mut taken = Claimed::default();
    let named = device.configurations.iter().map(|configuration| {
        let name = snake(&configuration.id);
        let name = taken.claim(name.clone(), |number| format!("{name}_{number}"));
        setup(device, Some(configuration), format!("_{name}"))
    });
    let named: Vec<Setup> = named.collect();
    std::iter::once(setup(device, default, String::new())).chain(named).collect()
}

fn setup(device: &Device, configuration: Option<&Configuration>, tail: String) -> Setup {
    let writes: Vec<&SdoWrite> =
        configuration.iter().flat_map(|configuration| &configuration.startup).collect();
    let own = writes.iter().filter(|write| !write.address.index.is_derived());
    let (early, late): (Vec<&SdoWrite>, Vec<&SdoWrite>) =
        own.partition(|write| EARLY.contains(&&*write.transition));
    Setup {
        tail,
        title: configuration.map_or_else(|| "as the device starts".to_owned(), |it| prose(&it.name)),
        managers: device.sync_managers.iter().map(|it| manager(device, configuration, it)).collect(),
        sdos: early.into_iter().map(sdo).collect(),
        later: late.len(),
    }
}

fn manager(device: &Device, configuration: Option<&Configuration>, of: &SyncManager) -> Manager {
    // a configuration is about the first sync manager of a direction
    let is_first = device.sync_manager(of.role).is_some_and(|first| first.number == of.number);
    let chosen = configuration.filter(|_| is_first).and_then(|configuration| match of.role {
        Role::Outputs => configuration.outputs.as_deref(),
        Role::Inputs => configuration.inputs.as_deref(),
        Role::MailboxOut | Role::MailboxIn => None,
    });
    let indices: &[Index] = chosen.unwrap_or(&of.pdos);
    let mapped = |index: &Index| {
        let own = configuration.and_then(|it| it.mapping.iter().find(|pdo| pdo.index == *index));
        own.or_else(|| device.pdo(*index)).map(|pdo| mapping(device, pdo))
    };
    Manager {
        number: of.number,
        is_output: of.role.is_written(),
        is_process_data: of.role.is_process_data(),
        watchdog: of.control & 0x40 != 0,
        pdos: indices.iter().filter_map(mapped).collect(),
    }
}

fn mapping(device: &Device, pdo: &Pdo) -> Mapping {
    let entries = pdo.entries.iter().map(|mapped| match mapped.address {
        Some(address) => (address.index.0, address.subindex, mapped.bits),
        None => (0, 0, mapped.bits),
    });
    Mapping {
        index: pdo.index.0,
        title: prose(&device.on_axis(&pdo.name, pdo.axis)),
        entries: entries.collect(),
    }
}

fn sdo(write: &SdoWrite) -> Sdo {
    Sdo {
        index: write.address.index.0,
        subindex: write.address.subindex,
        bits: write.data.len() * 8,
        value: write.data.iter().take(8).rev().fold(0, |value, byte| (value << 8) | u64::from(*byte)),
        data: write.data.clone(),
        title: prose(&write.comment),
    }
}
