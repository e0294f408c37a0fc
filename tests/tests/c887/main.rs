//! The description of the C-887 against the tables of its manual, fact by fact.

#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

#[path = "../described/mod.rs"]
mod described;
mod dictionary;
mod errors;
mod process_data;
mod states;

use std::sync::LazyLock;

use devc::lint::Checked;
use devc::model::{Device, Family};

use described::{departs, plain, rows};

/// The device as `devices/c887` describes it.
fn device() -> &'static Device {
    static FAMILY: LazyLock<Checked<Family>> = LazyLock::new(|| described::family("c887"));
    FAMILY.members.first().expect("there is a device")
}
