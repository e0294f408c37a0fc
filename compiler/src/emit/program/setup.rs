//! What a master sets up of a device: what is by default, and each configuration. Assignment and mapping are its own business.

use std::collections::BTreeMap;

use serde::Serialize;

use super::names::Names;
use super::transport::{self, Clock};
use super::value::{self, Kind};
use crate::emit::escape::prose;
use crate::emit::identifier::{Claimed, snake};
use crate::model::{
    Address, Configuration, Device, Dimension, Family, Index, Mapped, Pdo, Role, SdoWrite, Symbol,
    SyncManager,
};

/// A way to set a device up.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Setup {
    /// What stands behind the name of the device in each name.
    tail: String,
    title: String,
    /// The configuration that it brings about; none for what is by default.
    pub(in crate::emit) configuration: Option<String>,
    pub(in crate::emit) cycle_ns: Option<u64>,
    pub(in crate::emit) managers: Vec<Assigned>,
    /// SDOs of 1, 2 and 4 bytes are numbers, others bytes.
    pub(in crate::emit) sdos: Vec<Sdo>,
    /// How many writes belong to a change of state in which the master makes none.
    pub(in crate::emit) later: usize,
}

/// A sync manager with what it carries.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Assigned {
    pub(in crate::emit) number: u8,
    pub(in crate::emit) is_output: bool,
    pub(in crate::emit) is_process_data: bool,
    pub(in crate::emit) watchdog: bool,
    pub(in crate::emit) pdos: Vec<Mapping>,
}

/// A PDO with its entries.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Mapping {
    pub(in crate::emit) index: u16,
    pub(in crate::emit) title: String,
    pub(in crate::emit) entries: Vec<Entry>,
}

/// What is mapped: index and subindex are 0 for a gap.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Entry {
    pub(in crate::emit) index: u16,
    pub(in crate::emit) subindex: u8,
    pub(in crate::emit) bits: u32,
    /// None for a gap.
    pub(in crate::emit) value: Option<Value>,
}

/// A value that is exchanged.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Value {
    /// What it is called, behind the axis where there are several; unique among those of a direction.
    pub(in crate::emit) name: String,
    /// What it is on the first axis.
    #[serde(skip)]
    pub(in crate::emit) leading: Address,
    pub(in crate::emit) axis: Option<u8>,
    pub(in crate::emit) kind: Kind,
    /// How much of what a step is.
    #[serde(skip)]
    pub(in crate::emit) step: Option<Step>,
}

/// A step of a raw value.
#[derive(Debug, Clone, Copy)]
pub(in crate::emit) struct Step {
    pub(in crate::emit) dimension: Dimension,
    /// In the smallest unit that [`Symbol`] knows, as a fraction.
    pub(in crate::emit) smallest: (f64, f64),
}

/// A write through the mailbox.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Sdo {
    pub(in crate::emit) index: u16,
    pub(in crate::emit) subindex: u8,
    pub(in crate::emit) bits: usize,
    pub(in crate::emit) value: u64,
    pub(in crate::emit) data: Vec<u8>,
    pub(in crate::emit) title: String,
}

/// The changes of state before which the master writes.
const EARLY: [&str; 2] = ["IP", "PS"];

/// The default first, which is the default configuration if there is one.
pub(in crate::emit) fn setups(device: &Device) -> Vec<Setup> {
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

/// What the files of all ways of a device begin with.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Head {
    family: String,
    name: String,
    vendor_id: u32,
    product_code: u32,
    /// The first way to keep time, if there is one.
    clock: Option<Clock>,
    pub(in crate::emit) has_axes: bool,
}

fn head(device: &Device, family: &str) -> Head {
    let clocks = transport::clocks(device, &mut Names::new(&[], ""));
    Head {
        family: prose(family),
        name: prose(&device.name),
        vendor_id: device.identity.vendor_id,
        product_code: device.identity.product_code,
        clock: clocks.into_iter().next(),
        has_axes: device.axes.len() > 1,
    }
}

/// Makes a text for the default of each member, and for the configurations that are not it, each by the name that its file
/// can have.
pub(in crate::emit) fn each_way(
    family: &Family,
    end: &str,
    text: impl Fn(&Head, &Setup) -> String,
) -> BTreeMap<String, Vec<u8>> {
    let (mut taken, mut files) = (Claimed::default(), BTreeMap::new());
    for device in &family.members {
        let head = head(device, &family.id);
        let default = device.configurations.iter().find(|it| it.default).map(|it| it.id.as_str());
        for setup in setups(device) {
            let own = setup.configuration.as_deref().filter(|_| !setup.is_default());
            if own.is_some() && own == default {
                continue;
            }
            let name = own.map_or(device.id.clone(), |own| format!("{}-{}", device.id, snake(own)));
            let name = taken.claim(name.clone(), |number| format!("{name}_{number}"));
            files.insert(format!("{name}{end}"), text(&head, &setup).into_bytes());
        }
    }
    files
}

impl Setup {
    /// Whether a master takes it if nothing else is chosen.
    pub(in crate::emit) fn is_default(&self) -> bool {
        self.tail.is_empty()
    }
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
        configuration: configuration.map(|it| it.id.clone()),
        cycle_ns: configuration.and_then(|it| it.cycle_time).map(|time| time.0),
        managers: device.sync_managers.iter().map(|it| manager(device, configuration, it)).collect(),
        sdos: early.into_iter().map(sdo).collect(),
        later: late.len(),
    }
}

fn manager(device: &Device, configuration: Option<&Configuration>, of: &SyncManager) -> Assigned {
    // a configuration is about the first sync manager of a direction
    let is_first = device.sync_manager(of.role).is_some_and(|first| first.number == of.number);
    let chosen = configuration.filter(|_| is_first).and_then(|configuration| match of.role {
        Role::Outputs => configuration.outputs.as_deref(),
        Role::Inputs => configuration.inputs.as_deref(),
        Role::MailboxOut | Role::MailboxIn => None,
    });
    let indices: &[Index] = chosen.unwrap_or(&of.pdos);
    let mut names = Claimed::default();
    let mapped = |index: &Index| {
        let own = configuration.and_then(|it| it.mapping.iter().find(|pdo| pdo.index == *index));
        own.or_else(|| device.pdo(*index)).map(|pdo| mapping(device, pdo, &mut names))
    };
    Assigned {
        number: of.number,
        is_output: of.role.is_written(),
        is_process_data: of.role.is_process_data(),
        watchdog: of.control & 0x40 != 0,
        pdos: indices.iter().filter_map(mapped).collect(),
    }
}

fn mapping(device: &Device, pdo: &Pdo, names: &mut Claimed) -> Mapping {
    let entries = pdo.entries.iter().map(|mapped| Entry {
        index: mapped.address.map_or(0, |address| address.index.0),
        subindex: mapped.address.map_or(0, |address| address.subindex),
        bits: mapped.bits,
        value: mapped.address.map(|address| value(device, pdo, mapped, address, names)),
    });
    let entries = entries.collect();
    Mapping { index: pdo.index.0, title: prose(&device.on_axis(&pdo.name, pdo.axis)), entries }
}

fn value(device: &Device, pdo: &Pdo, mapped: &Mapped, address: Address, names: &mut Claimed) -> Value {
    let object = device.object(address.index);
    let axis = object.map_or(pdo.axis, |object| object.axis);
    let of = axis.filter(|_| device.axes.len() > 1).and_then(|axis| device.axes.get(usize::from(axis)));
    let name = snake(&format!("{}-{}", of.map_or("", |axis| &axis.name), mapped.id));
    let index = object.map_or(address.index, |object| object.leading);
    Value {
        name: names.claim(name.clone(), |number| format!("{name}_{number}")),
        leading: Address { index, ..address },
        axis,
        kind: value::of(device, mapped).0,
        step: step(device, address, axis),
    }
}

/// Where the unit has a symbol with a meaning.
fn step(device: &Device, address: Address, axis: Option<u8>) -> Option<Step> {
    let unit = device.unit(device.entry(address)?.unit.as_deref()?)?;
    let unit = unit.on(axis)?;
    let symbol = Symbol::find(&unit.symbol)?;
    let (units, raw) = unit.scale.map_or((1, 1), |scale| (scale.units, scale.raw));
    let smallest = (units.checked_mul(symbol.smallest)? as f64, raw as f64);
    Some(Step { dimension: symbol.dimension, smallest })
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
