//! A description becomes a drive on the wire, before there is hardware.
//!
//! A [`Subdevice`] is an EtherCAT subdevice controller with a [`Firmware`] behind it; a [`Wire`] takes frames through one or
//! several of them, as bytes to bytes.

mod clocks;
mod cycles;
mod described;
pub mod drive;
mod esc;
mod event;
mod firmware;
mod frame;
#[cfg(feature = "raw-socket")]
mod interface;
mod mail;
mod process;
mod subdevice;
mod trace;
mod wire;

pub use clocks::Clocks;
pub use cycles::Cycles;
pub use event::{Event, ManagerFault, Wrong, state_name};
pub use firmware::Firmware;
#[cfg(feature = "raw-socket")]
pub use interface::Interface;
pub use subdevice::Subdevice;
pub use trace::{Trace, Way};
pub use wire::Wire;
