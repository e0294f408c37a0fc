//! A file as plain structs, whatever its encoding, order and age: an ESI, an EDS, or a list of SDO information.

mod basic_types;
mod default_image;
mod device;
mod diagnosis;
mod dictionary;
mod doubts;
mod eds;
mod element;
mod encoding;
mod esi;
mod meanings;
mod modules;
mod number;
mod objects;
mod parse;
mod process_data;
mod sdos;
mod sheet;
mod words;

use std::borrow::Cow;

pub(super) use doubts::{entities, foreign, is_miscoded};
pub(super) use eds::device as sheet_device;
pub(super) use element::{At, Element, Unread};
pub(super) use esi::{
    Alternative, Channel, Choice, Datum, Device, Esi, Fmmu, Head, InitCmd, Mailbox, Message, ModeManager,
    Object, OpMode, OpenSlot, Pdo, PdoEntry, Plug, Property, Shape, Signal, Sm, Texts, Timeout, Value,
    Written,
};
pub(super) use number::number;
pub(super) use sdos::{List, list};
pub(super) use sheet::Sheet;
pub(super) use words::one_line;

/// What a file can be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    /// An ESI file, in XML.
    Esi,
    /// An EDS, in sections with keys.
    Eds,
    /// What `ethercat sdos` prints.
    Sdos,
}

impl Format {
    /// What a text looks like.
    pub(super) fn of(text: &str) -> Self {
        let begin = text.lines().map(str::trim).find(|line| !line.is_empty() && !line.starts_with(';'));
        let is_section = begin.is_some_and(|line| line.starts_with('[') && line.ends_with(']'));
        match is_section {
            true => Self::Eds,
            false if sdos::is_list(text) => Self::Sdos,
            false => Self::Esi,
        }
    }

    /// The key of the document that the facts are from, and what it is.
    pub(super) fn document(self) -> (&'static str, &'static str) {
        match self {
            Self::Esi => ("esi", "EtherCAT slave information"),
            Self::Eds => ("eds", "Electronic data sheet"),
            Self::Sdos => ("sdos", "SDO information of a device"),
        }
    }
}

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
        INFO | "EtherCATInfoList" => Ok(root),
        "EtherCATModule" => Err((root.at(), "it describes modules only, and no device".to_owned())),
        other => Err((root.at(), format!("it is no ESI file: its root is `{other}`"))),
    }
}

/// The element that a vendor describes devices in.
const INFO: &str = "EtherCATInfo";

/// What vendors describe: the root alone, or what is listed in it.
pub(super) fn infos<'e, 't>(root: &'e Element<'t>) -> Vec<&'e Element<'t>> {
    if root.name() == INFO { vec![root] } else { root.all(INFO).collect() }
}

/// What holds for all that a vendor describes.
pub(super) fn file(info: &Element<'_>) -> Esi {
    let vendor = info.child("Vendor");
    Esi {
        vendor_id: vendor.and_then(|vendor| vendor.child_as("Id", number)),
        vendor_name: vendor.and_then(|vendor| words::name(vendor, "Name")),
    }
}

/// The elements of the devices that a vendor describes.
pub(super) fn devices<'e, 't>(info: &'e Element<'t>) -> Vec<&'e Element<'t>> {
    let devices = info.child("Descriptions").and_then(|it| it.child("Devices"));
    devices.into_iter().flat_map(|devices| devices.all("Device")).collect()
}

/// What tells a device from the others.
pub(super) fn head(device: &Element<'_>) -> Head {
    device::head(device)
}

/// A device with the modules that are in its slots by default.
pub(super) fn device<'e, 't>(
    root: &'e Element<'t>,
    element: &'e Element<'t>,
) -> (Device, Vec<&'e Element<'t>>) {
    let mut device = device::device(element);
    let modules = modules::plug(root, element, &mut device);
    (device, modules)
}
