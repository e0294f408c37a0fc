//! What the standard makes objects repeat of other sections (ETG.1000.6, ETG.5001, CiA 301): the device type 0x1000, the
//! name 0x1008, the identity 0x1018, the slots of a modular device from 0xF000. A default that the description gives
//! stays; rules compare it.

#[cfg(test)]
mod tests;

use crate::model::{DataType, Entry, Identity, Object, Slots, Value};
use crate::raw::{RawAxes, RawHead};
use crate::source;

/// The additional information of a device with several axes, CiA 301.
const SEVERAL: u32 = 0xFFFF;

/// Gives these objects the defaults that other sections state.
pub(super) fn fill(
    objects: &mut [Object],
    head: &RawHead,
    identity: &Identity,
    axes: Option<&RawAxes>,
    slots: &Slots<'_>,
) {
    for object in objects {
        match object.index.0 {
            0x1000 => object.entries.iter_mut().for_each(|entry| device_type(entry, head, axes)),
            0x1008 => object.entries.iter_mut().for_each(|entry| name(entry, &head.name)),
            0x1018 => object.entries.iter_mut().for_each(|entry| number(entry, identity)),
            _ => object.entries.iter_mut().for_each(|entry| slot(entry, slots)),
        }
    }
}

fn device_type(entry: &mut Entry, head: &RawHead, axes: Option<&RawAxes>) {
    let information = match axes.map_or(1, |axes| axes.names.len()) {
        0 | 1 => axes.and_then(|axes| axes.add_info).map(u32::from),
        _ => Some(SEVERAL),
    };
    let profile = head.profile.filter(|profile| *profile <= 0xFFFF);
    if let Some((profile, information)) = profile.zip(information) {
        state(entry, Value::Integer((information << 16 | profile).into()));
    }
}

/// The name of the device, for a text whose length nobody states: it is as long as the name.
fn name(entry: &mut Entry, name: &str) {
    let unsized_text = entry.origin.node("type").is_some_and(|node| match &node.value {
        source::Value::String(text) => **text == *"STRING",
        _ => false,
    });
    if unsized_text && entry.default.is_none() {
        entry.data_type = DataType::Text(u16::try_from(name.len()).unwrap_or(u16::MAX).max(1));
        state(entry, Value::Text(name.to_owned()));
    }
}

fn number(entry: &mut Entry, identity: &Identity) {
    let stated = match entry.address.subindex {
        1 => identity.vendor_id,
        2 => identity.product_code,
        3 => identity.revision,
        4 if identity.origin.has("serial") => identity.serial,
        _ => return,
    };
    if entry.data_type == DataType::Uint(32) {
        state(entry, Value::Integer(stated.into()));
    }
}

fn slot(entry: &mut Entry, slots: &Slots<'_>) {
    if let Some(value) = slots.value(entry.address) {
        state(entry, Value::Integer(value.into()));
    }
}

fn state(entry: &mut Entry, value: Value) {
    entry.default.get_or_insert(value);
}
