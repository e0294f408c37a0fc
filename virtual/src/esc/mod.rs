//! The EtherCAT subdevice controller: what stands between the wire and the firmware.

mod access;
mod clock;
mod controller;
mod eeprom;
mod fmmu;
mod latch;
mod manager;
mod memory;
pub(crate) mod registers;
mod signals;
mod watchdog;
mod written;

pub(crate) use controller::Controller;
use fmmu::Fmmu;
pub(crate) use manager::SyncManager;
pub(crate) use memory::Memory;
use written::Written;
