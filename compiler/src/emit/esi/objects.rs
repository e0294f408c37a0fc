//! `Object`: one index of the dictionary.

use super::composite::{Member, Shape};
use super::element::Element;
use super::flags;
use super::literal::{Bytes, Hex, comment};
use super::types::Types;
use crate::model::{Object, Value};

/// An object.
pub(super) fn object(object: &Object, types: &Types) -> Element {
    let shape = Shape::of(object);
    Element::new("Object")
        .child(Element::leaf("Index", Hex(object.index.0)))
        .child(Element::worded("Name", &object.name))
        .child(remarks(object, &shape))
        .child(Element::leaf("Type", types.name_of(object)))
        .child(Element::leaf("BitSize", shape.bits()))
        .child(info(&shape))
        .child(flags::of_object(object))
}

/// What is to be said of the object, and of its value if it has but one.
fn remarks(object: &Object, shape: &Shape<'_>) -> Option<Element> {
    let own = match shape {
        Shape::Var(only) => [&only.entry.about, &only.entry.note],
        Shape::Array(_) | Shape::Record(_) => [&None, &None],
    };
    comment([&object.about, &object.note].into_iter().chain(own))
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
