//! A description becomes a drive on the wire, before there is hardware.

pub mod drive;
mod firmware;

pub use firmware::Firmware;
