//! What the device is and how a master recognises it.

use serde::Serialize;

use crate::emit::markdown::context::Context;
use crate::emit::markdown::document::Chapter;
use crate::emit::markdown::inline::{code, link, list, text};
use crate::emit::markdown::number::bytes;
use crate::emit::markdown::table::Table;
use crate::model::{Device, Role};

#[derive(Serialize)]
pub(in crate::emit::markdown) struct View {
    about: String,
    facts: Table,
    identity: Table,
    limits: Table,
    source: String,
}

impl Chapter for View {
    const ID: &'static str = "device";
    const TITLE: &'static str = "Device";
    const TEMPLATE: &'static str = include_str!("../templates/device.md.j2");

    fn view(context: &Context<'_>) -> Option<Self> {
        let device = context.device;
        Some(Self {
            about: context.paragraphs(device.about.as_deref()),
            facts: facts(context),
            identity: identity(device),
            limits: limits(context),
            source: context.source_line(device.identity.source.as_ref()),
        })
    }
}

fn facts(context: &Context<'_>) -> Table {
    let device = context.device;
    let names = list(context.axis_names().map(text));
    let axes = match context.has_axes() {
        true => format!("{}: {}", link(device.axes.len(), "axes"), names),
        false => String::new(),
    };
    let rows = [
        ("Vendor", text(&device.vendor)),
        ("Models", list(device.models.iter().map(|model| text(model)))),
        ("Type", code(&device.type_name)),
        ("Group", text(&device.group)),
        ("Profile", device.profile.map_or(String::new(), |profile| format!("CiA {profile}"))),
        ("Axes", axes),
        ("Process data", process_data(context)),
        ("Ports", ports(&device.physics)),
        ("EEPROM", eeprom(device)),
    ];
    let rows = rows.into_iter().filter(|(_, value)| !value.is_empty());
    Table::of(["Device", "Facts"], rows, |(name, value)| [name.into(), value])
}

fn process_data(context: &Context<'_>) -> String {
    let size = |role| bytes(context.device.image_bytes(role));
    if context.device.pdos.is_empty() {
        return String::new();
    }
    let sizes = format!("{} of outputs, {} of inputs", size(Role::Outputs), size(Role::Inputs));
    format!("{} by default", link(sizes, "process-data"))
}

/// What each port is, by the letters of an ESI.
fn ports(physics: &str) -> String {
    let port = |letter| match letter {
        'Y' => "Ethernet (MII)".into(),
        'H' => "Ethernet (MII, fast hot connect)".into(),
        'K' => "E-bus (LVDS)".into(),
        letter => text(&String::from(letter)),
    };
    let ports = physics.chars().filter(|letter| *letter != ' ').map(port);
    list(ports.enumerate().map(|(number, port)| format!("{number}: {port}")))
}

fn eeprom(device: &Device) -> String {
    let config: Vec<String> = device.eeprom.config_data.iter().map(|byte| format!("{byte:02X}")).collect();
    let size = bytes(device.eeprom.size);
    if config.is_empty() { size } else { format!("{size}, begins with {}", code(config.join(" "))) }
}

fn limits(context: &Context<'_>) -> Table {
    Table::of(["Limit", "Figure", "Notes", "Source"], &context.device.limits, |limit| {
        [
            text(&limit.name),
            context.prose(&limit.value),
            context.optional(limit.about.as_deref()),
            context.source(limit.source.as_ref()),
        ]
    })
}

fn identity(device: &Device) -> Table {
    let identity = &device.identity;
    let rows = [
        ("Vendor ID", identity.vendor_id),
        ("Product code", identity.product_code),
        ("Revision number", identity.revision),
        ("Serial number", identity.serial),
    ];
    Table::of(["Identity", "Hexadecimal", "Decimal"], rows, |(name, value)| {
        [name.into(), code(format!("{value:#010X}").replace("0X", "0x")), code(value)]
    })
}
