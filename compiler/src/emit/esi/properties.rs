//! `Property`: what the vendor's own tools are told of objects and types.

use super::element::Element;
use crate::model::Property;

/// What the vendor's tools are told.
pub(super) fn properties(properties: &[Property]) -> impl Iterator<Item = Element> {
    properties.iter().map(|property| {
        Element::new("Property")
            .child(Element::leaf("Name", &property.name))
            .child(property.value.as_ref().map(|value| Element::leaf("Value", value)))
            .child(property.about.as_ref().map(|about| Element::worded("Desc", about)))
    })
}
