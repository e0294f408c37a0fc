//! `Object`: one index of the dictionary.

use super::composite::{Member, Shape};
use super::element::Element;
use super::frame::Frame;
use super::literal::Bytes;
use super::properties::properties;
use super::types::Types;
use super::{comment, flags, names, unit};
use crate::model::{Device, Object, Value};

/// An object.
pub(super) fn object(frame: Frame<'_>, object: &Object, shape: &Shape<'_>, types: &Types) -> Element {
    Element::new("Object")
        .child(frame.object(object.index))
        .children(names::named(frame, &object.name, &object.names, object.axis))
        .child(comment::of_object(object, shape))
        .child(Element::leaf("Type", types.name_of(object, shape)))
        .child(Element::leaf("BitSize", shape.bits()))
        .child(info(frame.device(), object, shape))
        .child(flags::of_object(object))
        .child(Element::new("Properties").children(properties(&object.properties)).unless_empty())
}

/// The values of an object: its own, or those of every member in order.
fn info(device: &Device, object: &Object, shape: &Shape<'_>) -> Option<Element> {
    let values = |member: &Member<'_>| values(member).child(unit::of(device, member.entry, object.axis));
    match shape {
        Shape::Var(only) => values(only).unless_empty(),
        Shape::Array(members) | Shape::Record(members) => {
            let item = |member: &Member<'_>| {
                Element::new("SubItem").child(Element::leaf("Name", &member.name)).child(values(member))
            };
            Some(Element::new("Info").children(members.iter().map(item)))
        }
    }
}

fn values(member: &Member<'_>) -> Element {
    let data = |tag: &'static str, value: &Option<Value>| {
        value.as_ref().map(|value| Element::leaf(tag, Bytes(&value.little_endian(member.data_type))))
    };
    let entry = member.entry;
    Element::new("Info")
        .child(data("MinData", &entry.min))
        .child(data("MaxData", &entry.max))
        .child(data("DefaultData", &entry.default))
}
