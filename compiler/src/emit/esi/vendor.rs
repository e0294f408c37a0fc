//! `Vendor`: who made the devices.

use super::element::Element;
use super::literal::Hex;
use crate::model::Device;

/// The vendor of a device; all devices of a file have the same.
pub(super) fn vendor(device: &Device) -> Element {
    Element::new("Vendor")
        .child(Element::leaf("Id", Hex(device.identity.vendor_id)))
        .child(Element::worded("Name", &device.vendor))
}
