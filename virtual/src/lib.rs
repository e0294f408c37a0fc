//! A description becomes a drive on the wire, before there is hardware.

mod firmware;

pub use firmware::Firmware;
