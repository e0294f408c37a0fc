//! `Profile`: the drive profile, a channel for each axis, and the object dictionary.

use super::composite::Shape;
use super::element::Element;
use super::objects;
use super::types::Types;
use crate::model::{Address, Device, Index};

/// The profile with the dictionary.
pub(super) fn profile(device: &Device) -> Element {
    let shapes: Vec<_> = device.objects.iter().map(|object| (object, Shape::of(object))).collect();
    let types = Types::of(&shapes);
    let objects = shapes.iter().map(|(object, shape)| objects::object(object, shape, &types));
    let objects = Element::new("Objects").children(objects);
    let dictionary = Element::new("Dictionary").child(types.declarations()).child(objects);
    Element::new("Profile").children(number(device)).children(channels(device)).child(dictionary)
}

fn channels(device: &Device) -> impl Iterator<Item = Element> {
    let drives = device.axes.iter().filter(|_| device.profile.is_some());
    drives.map(|axis| {
        Element::new("ChannelInfo").children(number(device)).child(Element::worded("DisplayName", &axis.name))
    })
}

/// The profile's number and its additional information: the two words of the device type.
fn number(device: &Device) -> impl Iterator<Item = Element> {
    let number = device.profile.map(|number| Element::leaf("ProfileNo", number));
    let information = device_type(device)
        .filter(|value| Some(value & 0xFFFF) == device.profile && value >> 16 != 0)
        .map(|value| Element::leaf("AddInfo", value >> 16));
    number.into_iter().chain(information)
}

/// What object 0x1000 says.
fn device_type(device: &Device) -> Option<u32> {
    let entry = device.entry(Address { index: Index(0x1000), subindex: 0 })?;
    entry.default.as_ref()?.integer().and_then(|value| u32::try_from(value).ok())
}
