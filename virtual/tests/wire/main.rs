//! A subdevice as masters see it: frames in, frames out.
#![allow(clippy::expect_used, clippy::unwrap_used, clippy::indexing_slicing, clippy::panic)] // tests may

#[path = "../shared/carried.rs"]
mod carried;
mod clocks;
mod devices;
mod eeprom;
mod files;
mod frames;
mod image;
mod in_ethercrab;
mod managers;
mod mapping;
mod master;
mod served;
mod several;
mod states;
mod trace;
mod wired;
