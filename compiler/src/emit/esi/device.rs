//! `Device`: its parts in the order that the schema demands.

use super::element::Element;
use super::frame::Frame;
use super::literal::{Bytes, Hex, prose};
use super::{dc, eeprom, info, mailbox, pdo, profile, slots, sync_managers};
use crate::model::{CheckedCode, CheckedRevision, Device, Direction};

/// A device.
pub(super) fn device(device: &Device) -> Element {
    Element::new("Device")
        .with("Physics", &device.physics)
        .child(type_and_identity(device))
        .children(device.identity.replaces.iter().map(hidden))
        .children(Element::in_languages("Name", name(device), &device.names))
        .children(device.url.iter().flat_map(|url| Element::in_languages("URL", url, &device.urls)))
        .child(info::info(device))
        .child(Element::leaf("GroupType", &device.group))
        .child(profile::profile(device))
        .children(sync_managers::fmmus(device))
        .children(device.sync_managers.iter().map(sync_managers::sync_manager))
        .children(device.sync_units().into_iter().map(|unit| Element::leaf("Su", unit)))
        .children(pdo::in_order(Frame::Device(device), Direction::Rx))
        .children(pdo::in_order(Frame::Device(device), Direction::Tx))
        .child(mailbox::mailbox(device))
        .child(dc::dc(device))
        .child(slots::slots(device))
        .child(eeprom::eeprom(&device.eeprom))
        .child(device.image.as_ref().map(|image| Element::leaf("ImageData16x14", Bytes(&image.bytes.0))))
}

fn type_and_identity(device: &Device) -> Element {
    Element::leaf("Type", &device.type_name)
        .with("ProductCode", Hex(device.identity.product_code))
        .with("RevisionNo", Hex(device.identity.revision))
        .with_some("UseLrdLwr", device.no_lrw.then_some("1"))
        .with_some("CheckProductCode", device.identity.check_product_code.map(CheckedCode::name))
        .with_some("CheckRevisionNo", device.identity.check_revision.map(CheckedRevision::name))
}

/// A revision that tools no longer offer.
fn hidden(revision: &u32) -> Element {
    Element::new("HideType").with("RevisionNo", Hex(*revision))
}

/// What a person picks from a list: the name to order by, and behind a colon what that is.
fn name(device: &Device) -> String {
    match &device.title {
        Some(title) => prose(&format!("{}: {title}", device.name)),
        None => device.name.clone(),
    }
}
