//! Who the device is, its sync managers and its clocks.

use serde::Serialize;

use super::names::Names;
use crate::emit::escape::prose;
use crate::model::{Device, SyncManager, SyncMode};

/// What object 0x1018 says.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Identity {
    pub(in crate::emit) vendor_id: u32,
    pub(in crate::emit) product_code: u32,
    pub(in crate::emit) revision: u32,
}

/// A sync manager.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Manager {
    pub(in crate::emit) number: u8,
    pub(in crate::emit) title: &'static str,
    pub(in crate::emit) is_output: bool,
    pub(in crate::emit) is_process_data: bool,
    pub(in crate::emit) address: u16,
    pub(in crate::emit) size: u16,
    pub(in crate::emit) control: u8,
    /// Whether it has a watchdog: bit 6 of the control byte.
    pub(in crate::emit) watchdog: bool,
    /// The PDOs that it carries by default.
    pub(in crate::emit) pdos: Vec<u16>,
}

/// A way to keep time.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Clock {
    pub(in crate::emit) global: String,
    pub(in crate::emit) title: String,
    pub(in crate::emit) assign_activate: u16,
    pub(in crate::emit) sync0: Option<Signal>,
    pub(in crate::emit) sync1: Option<Signal>,
}

/// A signal of the clocks.
#[derive(Debug, Serialize)]
pub(in crate::emit) struct Signal {
    /// Its period in cycles of the master, or how often it comes in one if negative.
    pub(in crate::emit) cycles: i32,
    /// Its period where that does not follow the master.
    pub(in crate::emit) period_ns: Option<u64>,
    pub(in crate::emit) shift_ns: i64,
}

pub(super) fn identity(device: &Device) -> Identity {
    let of = &device.identity;
    Identity { vendor_id: of.vendor_id, product_code: of.product_code, revision: of.revision }
}

pub(super) fn managers(device: &Device) -> Vec<Manager> {
    let manager = |of: &SyncManager| Manager {
        number: of.number,
        title: of.role.key(),
        is_output: of.role.is_written(),
        is_process_data: of.role.is_process_data(),
        address: of.address,
        size: of.size,
        control: of.control,
        watchdog: of.control & 0x40 != 0,
        pdos: of.pdos.iter().map(|index| index.0).collect(),
    };
    device.sync_managers.iter().map(manager).collect()
}

pub(super) fn clocks(device: &Device, names: &mut Names) -> Vec<Clock> {
    let signal = |of: &crate::model::SyncSignal| Signal {
        cycles: of.cycles,
        period_ns: of.period.map(|period| period.0),
        shift_ns: of.shift.0,
    };
    let clock = |of: &SyncMode| Clock {
        global: names.global(&["dc", &of.id, "assign-activate"]),
        title: prose(&of.name),
        assign_activate: of.assign_activate,
        sync0: of.sync0.as_ref().map(signal),
        sync1: of.sync1.as_ref().map(signal),
    };
    device.clock_modes().iter().map(clock).collect()
}
