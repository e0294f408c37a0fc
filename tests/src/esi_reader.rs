//! A reader of ESI files that shares no code with what writes them: it knows only the schema.
//!
//! It is strict. What the schema lets be absent is an `Option` or an empty list; all else is an error that names
//! the line.

mod clocks;
mod device;
mod dictionary;
mod info;
mod node;
mod texts;

pub use clocks::{OpMode, Signal};
pub use device::{CoE, Device, Eeprom, Fmmu, InitCommand, Pdo, PdoEntry, SyncManager};
pub use dictionary::{DataType, Dictionary, Flags, Info, Object, SubItem, Value};
pub use texts::Message;

use node::{Node, children, number, only, text};

/// An ESI file.
#[derive(Debug)]
pub struct Esi {
    /// The version of the schema it follows.
    pub version: String,
    /// The id of the vendor.
    pub vendor_id: u32,
    /// The vendor's name.
    pub vendor_name: String,
    /// Type and name of each group.
    pub groups: Vec<(String, String)>,
    /// The devices.
    pub devices: Vec<Device>,
}

/// Reads a file.
///
/// # Errors
/// If it is no XML, or not what the schema demands as far as this reader looks.
pub fn read(xml: &str) -> Result<Esi, String> {
    let document = roxmltree::Document::parse(xml).map_err(|error| error.to_string())?;
    let root = document.root_element();
    let vendor = only(root, "Vendor")?;
    let descriptions = only(root, "Descriptions")?;
    Ok(Esi {
        version: root.attribute("Version").unwrap_or_default().to_owned(),
        vendor_id: number(vendor, "Id")?,
        vendor_name: text(vendor, "Name")?,
        groups: children(only(descriptions, "Groups")?, "Group").map(group).collect::<Result<_, _>>()?,
        devices: children(only(descriptions, "Devices")?, "Device")
            .map(device::read)
            .collect::<Result<_, _>>()?,
    })
}

fn group(node: Node<'_, '_>) -> Result<(String, String), String> {
    Ok((text(node, "Type")?, text(node, "Name")?))
}
