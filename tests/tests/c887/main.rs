//! The description of the C-887 against the tables of its manual, fact by fact.

#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

mod dictionary;
mod errors;
mod process_data;
mod states;

use std::path::Path;
use std::sync::LazyLock;

use devc::model::Device;
use devc::source::Disk;

/// The device as `devices/c887` describes it.
fn device() -> &'static Device {
    static DEVICE: LazyLock<Device> = LazyLock::new(|| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices/c887");
        let compilation = devc::compile(&Disk, &path);
        let family = compilation.family.expect("the description compiles");
        family.members.first().expect("there is a device").clone()
    });
    &DEVICE
}

/// The rows of a table of the manual.
fn rows<T: devc_tests::manual::Row>() -> Vec<T> {
    devc_tests::manual::rows().expect("the table can be read")
}
