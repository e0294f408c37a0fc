//! `Object`: one index of the dictionary.

use super::composite::{Member, Shape};
use super::element::Element;
use super::frame::Frame;
use super::literal::Bytes;
use super::types::Types;
use super::{comment, flags, names};
use crate::model::{Object, Property, Value};

/// An object.
pub(super) fn object(frame: Frame<'_>, object: &Object, shape: &Shape<'_>, types: &Types) -> Element {
    Element::new("Object")
        .child(frame.object(object.index))
        .children(names::named(frame, &object.name, &object.names, object.axis))
        .child(comment::of_object(object, shape))
        .child(Element::leaf("Type", types.name_of(object, shape)))
        .child(Element::leaf("BitSize", shape.bits()))
        .child(info(shape))
        .child(flags::of_object(object))
        .child(Element::new("Properties").children(properties(&object.properties)).unless_empty())
}

/// What the vendor's tools are told.
pub(super) fn properties(properties: &[Property]) -> impl Iterator<Item = Element> {
    properties.iter().map(|property| {
        Element::new("Property")
            .child(Element::leaf("Name", &property.name))
            .child(property.value.as_ref().map(|value| Element::leaf("Value", value)))
            .child(property.about.as_ref().map(|about| Element::worded("Desc", about)))
    })
}

/// The values of an object: its own, or those of every member in order.
fn info(shape: &Shape<'_>) -> Option<Element> {
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
