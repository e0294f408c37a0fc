//! `Object`: one index of the dictionary.

use super::composite::Shape;
use super::element::Element;
use super::flags;
use super::literal::{Bytes, Hex};
use super::types::{Types, comment};
use crate::model::{Entry, Object, Value};

/// An object.
pub(super) fn object(object: &Object, types: &Types) -> Element {
    let shape = Shape::of(object);
    Element::new("Object")
        .child(Element::leaf("Index", Hex(object.index.0)))
        .child(Element::worded("Name", &object.name))
        .children(remarks(object, shape.as_ref()))
        .child(Element::leaf("Type", types.name_of(object)))
        .child(Element::leaf("BitSize", shape.as_ref().map_or(0, Shape::bits)))
        .child(shape.as_ref().and_then(info))
        .child(flags::of_object(object))
}

fn remarks(object: &Object, shape: Option<&Shape<'_>>) -> Option<Element> {
    let only = match shape {
        Some(Shape::Var(entry)) => Some(*entry),
        _ => None,
    };
    let own = only.into_iter().flat_map(|entry| [&entry.about, &entry.note]);
    comment([&object.about, &object.note].into_iter().chain(own))
}

/// The values of an object: its own, or those of every member in order.
fn info(shape: &Shape<'_>) -> Option<Element> {
    match shape {
        Shape::Var(entry) => values(entry).unless_empty(),
        Shape::Array { .. } | Shape::Record(_) => {
            let items = shape.members().map(|member| {
                Element::new("SubItem").child(Element::leaf("Name", &member.name)).child(values(member.entry))
            });
            Some(Element::new("Info").children(items))
        }
    }
}

fn values(entry: &Entry) -> Element {
    let data = |tag: &'static str, value: &Option<Value>| {
        value.as_ref().map(|value| Element::leaf(tag, Bytes(&value.little_endian(entry.data_type))))
    };
    Element::new("Info")
        .child(data("MinData", &entry.min))
        .child(data("MaxData", &entry.max))
        .child(data("DefaultData", &entry.default))
}
