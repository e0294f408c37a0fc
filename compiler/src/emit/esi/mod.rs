//! ESI XML: the file that EtherCAT masters and configuration tools read.
//!
//! It follows ETG.2000 in the order of elements of schema 1.14, which newer schemas take as well. Each file
//! here makes one part of the document as a tree of `Element`s; `element` alone knows how XML is written.

mod choices;
mod comment;
mod composite;
mod dc;
mod device;
mod diagnosis;
mod eeprom;
mod element;
mod enumeration;
mod flags;
mod frame;
mod groups;
mod heading;
mod info;
mod literal;
mod mailbox;
mod names;
mod objects;
mod pdo;
mod primitive;
mod profile;
mod properties;
mod slots;
mod sync_managers;
mod types;
mod unit;
mod vendor;

use self::element::Element;
use super::{Emitter, Files, Options};
use crate::diagnostic::Rule;
use crate::lint::{Checked, rules};
use crate::model::Family;

/// Makes ESI XML.
#[derive(Debug)]
pub struct Esi;

/// The newest schema whose every element all readers in use know.
const SCHEMA: &str = "1.14";

/// What it cannot hold.
const LINTS: &[&Rule] = &[
    &rules::contradicted_config_data::RULE,
    &rules::contradicted_period::RULE,
    &rules::empty_name::RULE,
    &rules::impossible_boot_mailbox::RULE,
    &rules::impossible_eeprom_size::RULE,
    &rules::incomplete_timeouts::RULE,
    &rules::indistinct_members::RULE,
    &rules::missing_config_data::RULE,
    &rules::mixed_vendors::RULE,
    &rules::overlong_name::RULE,
    &rules::replaced_revision::RULE,
    &rules::undersized_eeprom::RULE,
    &rules::uneven_slots::RULE,
    &rules::unfit_image::RULE,
    &rules::unlike_slots::RULE,
    &rules::unslotted_axis::RULE,
    &rules::unspoken_ability::RULE,
];

impl Emitter for Esi {
    fn name(&self) -> &'static str {
        "xml"
    }

    fn summary(&self) -> &'static str {
        "ESI, for EtherCAT masters and configuration tools"
    }

    fn ends(&self) -> &'static [&'static str] {
        &[".xml"]
    }

    fn lints(&self) -> &'static [&'static Rule] {
        LINTS
    }

    fn is_default(&self) -> bool {
        true
    }

    fn emit(&self, family: &Checked<Family>, _: &Options) -> Files {
        Files::one(format!("{}.xml", family.id), document(family))
    }
}

/// The whole file.
fn document(family: &Family) -> String {
    element::document(&heading::heading(family), &root(family))
}

fn root(family: &Family) -> Element {
    let devices = family.members.iter().map(device::device);
    Element::new("EtherCATInfo")
        .with("xmlns:xsi", "http://www.w3.org/2001/XMLSchema-instance")
        .with("xsi:noNamespaceSchemaLocation", "EtherCATInfo.xsd")
        .with("Version", SCHEMA)
        .child(family.members.first().map(vendor::vendor))
        .child(
            Element::new("Descriptions")
                .child(groups::groups(family))
                .child(Element::new("Devices").children(devices))
                .child(slots::modules(family)),
        )
}
