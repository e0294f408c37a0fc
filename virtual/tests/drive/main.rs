//! Every drive that is described, from Init to axes that move.
#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

mod bench;
mod clocks;
mod communication;
mod faults;
mod homing;
mod modes;
mod parameters;
mod probes;
#[path = "../shared/mod.rs"]
mod shared;
