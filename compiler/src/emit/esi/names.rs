//! The names of what is there for an axis, in all languages.

use super::element::Element;
use super::frame::Frame;
use crate::model::{Mapped, Pdo, Translations};

/// What something is called, with its axis.
pub(super) fn named(frame: Frame<'_>, name: &str, names: &Translations, axis: Option<u8>) -> Vec<Element> {
    let others = names.iter();
    let others = others.map(|it| Element::translated("Name", frame.name(&it.text, axis), it.language));
    std::iter::once(Element::worded("Name", frame.name(name, axis))).chain(others).collect()
}

/// The name of what a PDO carries, with the axis of the object; what the dictionary lacks is of the PDO's axis.
pub(super) fn mapped(frame: Frame<'_>, pdo: &Pdo, mapped: &Mapped) -> Vec<Element> {
    let object = mapped.address.and_then(|address| frame.device().object(address.index));
    named(frame, &mapped.name, &mapped.names, object.map_or(pdo.axis, |object| object.axis))
}
