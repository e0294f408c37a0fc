//! `Device`: its parts in the order that the schema demands.

use super::element::Element;
use super::literal::{Hex, prose};
use super::{dc, eeprom, mailbox, pdo, profile, sync_managers};
use crate::model::{Device, Direction};

/// A device.
pub(super) fn device(device: &Device) -> Element {
    Element::new("Device")
        .with("Physics", &device.physics)
        .child(type_and_identity(device))
        .child(Element::worded("Name", name(device)))
        .child(Element::leaf("GroupType", &device.group))
        .child(profile::profile(device))
        .children(sync_managers::fmmus(device))
        .children(device.sync_managers.iter().map(sync_managers::sync_manager))
        .children(pdo::in_order(device, Direction::Rx))
        .children(pdo::in_order(device, Direction::Tx))
        .child(mailbox::mailbox(device))
        .child(dc::dc(device))
        .child(eeprom::eeprom(&device.eeprom))
}

fn type_and_identity(device: &Device) -> Element {
    Element::leaf("Type", &device.type_name)
        .with("ProductCode", Hex(device.identity.product_code))
        .with("RevisionNo", Hex(device.identity.revision))
}

/// What a person picks from a list: the name to order by, and behind a colon what that is.
fn name(device: &Device) -> String {
    match &device.title {
        Some(title) => prose(&format!("{}: {title}", device.name)),
        None => device.name.clone(),
    }
}
