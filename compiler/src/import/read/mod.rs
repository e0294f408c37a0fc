//! An ESI file as plain structs, whatever its encoding, order and age.

mod device;
mod dictionary;
mod element;
mod encoding;
mod esi;
mod number;
mod parse;
mod process_data;
mod words;

use std::borrow::Cow;

pub(super) use element::{At, Element, Unread};
pub(super) use esi::{
    Choice, Datum, Device, Esi, Fmmu, Head, InitCmd, Mailbox, Object, OpMode, Pdo, PdoEntry, Shape, Signal,
    Sm, Timeout, Value, Written,
};
pub(super) use number::number;

/// The largest file that is read, in bytes; the largest real ones have a tenth of it.
pub(super) const MAX_SIZE: usize = 64 << 20;

/// The text of a file, or why it has none.
pub(super) fn text(bytes: &[u8]) -> Result<Cow<'_, str>, String> {
    if bytes.len() > MAX_SIZE {
        return Err(format!("it is larger than the {} MiB that are read", MAX_SIZE >> 20));
    }
    encoding::text(bytes).map_err(str::to_owned)
}

/// The root of a file, or where and why it is no ESI file.
pub(super) fn root(text: &str) -> Result<Element<'_>, (At, String)> {
    let root = parse::parse(text)?;
    match root.name() {
        "EtherCATInfo" => Ok(root),
        "EtherCATModule" => Err((root.at(), "it describes modules only, and no device".to_owned())),
        "EtherCATInfoList" => {
            Err((root.at(), "it is a list of several ESI files; import them one by one".to_owned()))
        }
        other => Err((root.at(), format!("it is no ESI file: its root is `{other}`"))),
    }
}

/// What holds for the whole file.
pub(super) fn file(root: &Element<'_>) -> Esi {
    let vendor = root.child("Vendor");
    Esi {
        vendor_id: vendor.and_then(|vendor| vendor.child_as("Id", number)),
        vendor_name: vendor.and_then(|vendor| words::name(vendor, "Name")),
    }
}

/// The elements of the devices of a file.
pub(super) fn devices<'e, 't>(root: &'e Element<'t>) -> Vec<&'e Element<'t>> {
    let devices = root.child("Descriptions").and_then(|it| it.child("Devices"));
    devices.into_iter().flat_map(|devices| devices.all("Device")).collect()
}

/// What tells a device from the others.
pub(super) fn head(device: &Element<'_>) -> Head {
    device::head(device)
}

/// A device.
pub(super) fn device(device: &Element<'_>) -> Device {
    device::device(device)
}
