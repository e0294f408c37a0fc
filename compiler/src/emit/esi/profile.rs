//! `Profile`: the drive profile, a channel for each axis, the object dictionary and the diagnosis messages.

use super::composite::Shape;
use super::element::Element;
use super::frame::Frame;
use super::types::Types;
use super::{diagnosis, objects};
use crate::model::{Address, Device, Index};

/// The profile with the dictionary.
pub(super) fn profile(device: &Device) -> Element {
    Element::new("Profile")
        .children(number(device, information(device)))
        .children(channels(device))
        .child(dictionary(Frame::Device(device)))
        .child(diagnosis::messages(device))
}

/// What a module is, with its part of the dictionary.
pub(super) fn of_module(frame: Frame<'_>) -> Element {
    let device = frame.device();
    Element::new("Profile").children(number(device, channel(device))).child(dictionary(frame))
}

fn dictionary(frame: Frame<'_>) -> Element {
    let objects = frame.device().objects.iter().filter(|object| frame.has(object));
    let shapes: Vec<_> = objects.map(|object| (object, Shape::of(object))).collect();
    let types = Types::of(&shapes);
    let objects = shapes.iter().map(|(object, shape)| objects::object(frame, object, shape, &types));
    let objects = Element::new("Objects").children(objects);
    Element::new("Dictionary").child(types.declarations()).child(objects)
}

/// A channel for each axis; where axes are in slots, their modules say what they are.
fn channels(device: &Device) -> impl Iterator<Item = Element> {
    let drives = device.axes.iter().filter(|_| device.profile.is_some() && device.modules.is_empty());
    drives.map(|axis| {
        let name = (!axis.name.is_empty()).then(|| Element::worded("DisplayName", &axis.name));
        Element::new("ChannelInfo").children(number(device, channel(device))).child(name)
    })
}

/// What `AddInfo` of a device says that has several axes, CiA 301: look at each of them.
const SEVERAL: u32 = 0xFFFF;

/// What each axis is: what the description says of the axes, or the device's type if that is the type of one.
fn channel(device: &Device) -> Option<u32> {
    let said = device.arrangement.add_info.map(u32::from);
    said.or_else(|| information(device).filter(|information| *information != SEVERAL))
}

/// The profile's number with the additional information.
fn number(device: &Device, information: Option<u32>) -> impl Iterator<Item = Element> {
    let number = device.profile.map(|number| Element::leaf("ProfileNo", number));
    number.into_iter().chain(information.map(|information| Element::leaf("AddInfo", information)))
}

/// The additional information: the upper word of the device type, object 0x1000, if the lower one is the profile.
fn information(device: &Device) -> Option<u32> {
    let entry = device.entry(Address { index: Index(0x1000), subindex: 0 })?;
    let value = entry.default.as_ref()?.integer().and_then(|value| u32::try_from(value).ok())?;
    (Some(value & 0xFFFF) == device.profile && value >> 16 != 0).then_some(value >> 16)
}
