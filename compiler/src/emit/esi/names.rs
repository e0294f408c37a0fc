//! The names of what is there for an axis, in all languages.

use super::element::Element;
use crate::model::{Device, Mapped, Pdo, Translations};

/// What something is called, with its axis.
pub(super) fn named(device: &Device, name: &str, names: &Translations, axis: Option<u8>) -> Vec<Element> {
    let others = names.iter();
    let others = others.map(|it| Element::translated("Name", device.on_axis(&it.text, axis), it.language));
    std::iter::once(Element::worded("Name", device.on_axis(name, axis))).chain(others).collect()
}

/// The name of what a PDO carries, with the axis of the object; what the dictionary lacks is of the PDO's axis.
pub(super) fn mapped(device: &Device, pdo: &Pdo, mapped: &Mapped) -> Vec<Element> {
    let object = mapped.address.and_then(|address| device.object(address.index));
    named(device, &mapped.name, &mapped.names, object.map_or(pdo.axis, |object| object.axis))
}
