//! `DataTypes`: every type that an object, a member or another type names.

use std::collections::BTreeMap;

use super::composite::{Member, Shape};
use super::element::Element;
use super::enumeration::Enumeration;
use super::properties::properties;
use super::{comment, flags, primitive};
use crate::model::{Index, Object};

/// The types of a dictionary by name.
#[derive(Debug, Default)]
pub(super) struct Types {
    /// Basic types by their place in the file.
    basic: BTreeMap<(u8, u32), Element>,
    /// Types for values with meanings, in the order of their first use.
    enumerations: Vec<Enumeration>,
    /// Composite types with all that they are made of, by the object they are named after.
    composites: BTreeMap<Index, Vec<Element>>,
    /// Objects that share the composite type of another, by index, with that other.
    shared: BTreeMap<Index, Index>,
}

impl Types {
    /// The types of all objects.
    pub(super) fn of(objects: &[(&Object, Shape<'_>)]) -> Self {
        let mut types = Self::default();
        for member in objects.iter().flat_map(|(_, shape)| shape.members()) {
            types.learn(member);
        }
        for (object, shape) in objects {
            types.compose(object, shape, object.leading);
        }
        types
    }

    /// The type of an object.
    pub(super) fn name_of(&self, object: &Object, shape: &Shape<'_>) -> String {
        match shape {
            Shape::Var(only) => self.name_of_member(only),
            Shape::Array(_) | Shape::Record(_) => {
                name(*self.shared.get(&object.index).unwrap_or(&object.index))
            }
        }
    }

    /// `DataTypes`: basic types first, then enumerations, then composite types by index.
    pub(super) fn declarations(&self) -> Element {
        let numbered = self.enumerations.iter().enumerate();
        Element::new("DataTypes")
            .children(self.basic.values().cloned())
            .children(numbered.map(|(number, enumeration)| enumeration.declaration(number)))
            .children(self.composites.values().flatten().cloned())
    }

    fn learn(&mut self, member: &Member<'_>) {
        let elements = primitive::elements(member.data_type).map(|(of, _)| of);
        for data_type in [Some(member.data_type), elements].into_iter().flatten() {
            self.basic
                .entry(primitive::order(data_type))
                .or_insert_with(|| primitive::declaration(data_type));
        }
        let enumeration = Enumeration::of(member);
        self.enumerations.extend(enumeration.filter(|new| !self.enumerations.contains(new)));
    }

    /// Declares the composite type of an object, if it needs one: that of the object it repeats if it is the
    /// same, else one of its own.
    fn compose(&mut self, object: &Object, shape: &Shape<'_>, first: Index) {
        if matches!(shape, Shape::Var(_)) {
            return;
        }
        let composite = self.composite(shape, first);
        if *self.composites.entry(first).or_insert_with(|| composite.clone()) == composite {
            self.shared.insert(object.index, first);
        } else {
            self.composites.insert(object.index, self.composite(shape, object.index));
        }
    }

    fn name_of_member(&self, member: &Member<'_>) -> String {
        let Some(enumeration) = Enumeration::of(member) else { return primitive::name(member.data_type) };
        let number = self.enumerations.iter().position(|known| *known == enumeration);
        number.map_or_else(|| primitive::name(member.data_type), |number| enumeration.name(number))
    }

    /// The declarations of a composite type under the name of `index`.
    fn composite(&self, shape: &Shape<'_>, index: Index) -> Vec<Element> {
        let (array, sub_items) = match shape {
            Shape::Array(members) => self.array(members, index),
            Shape::Var(_) | Shape::Record(_) => {
                (None, shape.members().iter().map(|member| self.sub_item(member)).collect())
            }
        };
        let composite = Element::new("DataType")
            .child(Element::leaf("Name", name(index)))
            .child(Element::leaf("BitSize", shape.bits()))
            .children(sub_items);
        array.into_iter().chain([composite]).collect()
    }

    /// The type of all elements together, and the members of the array: subindex 0 and the elements as one,
    /// which has no subindex.
    fn array(&self, members: &[Member<'_>], index: Index) -> (Option<Element>, Vec<Element>) {
        let [count, first, ..] = members else { return (None, Vec::new()) };
        let name = format!("{}ARR", name(index));
        let bits = members.last().map_or(0, Member::end).saturating_sub(first.offset);
        let elements = members.len().saturating_sub(1);
        let declaration = Element::new("DataType")
            .child(Element::leaf("Name", &name))
            .child(Element::leaf("BaseType", self.name_of_member(first)))
            .child(Element::leaf("BitSize", bits))
            .child(array_info(elements));
        let all = Element::new("SubItem")
            .child(Element::leaf("Name", "Elements"))
            .child(Element::leaf("Type", name))
            .child(Element::leaf("BitSize", bits))
            .child(Element::leaf("BitOffs", first.offset))
            .child(flags::of_entry(first.entry));
        (Some(declaration), vec![self.sub_item(count), all])
    }

    fn sub_item(&self, member: &Member<'_>) -> Element {
        let entry = member.entry;
        Element::new("SubItem")
            .child(Element::leaf("SubIdx", entry.address.subindex))
            .child(Element::leaf("Name", &member.name))
            .children(display_names(member))
            .child(Element::leaf("Type", self.name_of_member(member)))
            .child(comment::of_entry(member))
            .child(Element::leaf("BitSize", member.data_type.bits()))
            .child(Element::leaf("BitOffs", member.offset))
            .child(flags::of_entry(entry))
            .children(properties(&entry.properties))
    }
}

/// What a tool shows instead of the name, which is in English.
fn display_names(member: &Member<'_>) -> Vec<Element> {
    let names = &member.entry.names;
    if names.is_empty() { Vec::new() } else { Element::in_languages("DisplayName", &member.name, names) }
}

fn array_info(elements: usize) -> Element {
    Element::new("ArrayInfo").child(Element::leaf("LBound", 1)).child(Element::leaf("Elements", elements))
}

fn name(index: Index) -> String {
    format!("DT{:04X}", index.0)
}
