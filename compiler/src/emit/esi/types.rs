//! `DataTypes`: every type that an object, a member or another type names.

use std::collections::BTreeMap;

use super::composite::{Member, Shape};
use super::element::Element;
use super::enumeration::Enumeration;
use super::literal::prose;
use super::{flags, primitive};
use crate::model::{Device, Entry, Index, Object};

/// The types of a dictionary by name.
#[derive(Debug, Default)]
pub(super) struct Types {
    /// Types for values with meanings, in the order of their first use.
    enumerations: Vec<Enumeration>,
    /// Composite types with all that they are made of, by the object they are named after.
    composites: BTreeMap<Index, Vec<Element>>,
    /// The composite type of each object that has one, by the object it is named after.
    named_after: BTreeMap<Index, Index>,
}

impl Types {
    /// The types of all objects. An object of a further axis shares the type of the first if both are the same.
    pub(super) fn of(device: &Device) -> Self {
        let mut types = Self::default();
        for entry in device.objects.iter().flat_map(|object| &object.entries) {
            if let Some(enumeration) = Enumeration::of(entry).filter(|it| !types.enumerations.contains(it)) {
                types.enumerations.push(enumeration);
            }
        }
        for object in &device.objects {
            let first = first_of_its_kind(device, object);
            let shared = types.composite(object, first);
            if types.composites.get(&first) == Some(&shared) {
                types.named_after.insert(object.index, first);
            } else if !shared.is_empty() {
                types.composites.insert(object.index, types.composite(object, object.index));
                types.named_after.insert(object.index, object.index);
            }
        }
        types
    }

    /// The type of an object.
    pub(super) fn name_of(&self, object: &Object) -> String {
        match (self.named_after.get(&object.index), object.entries.first()) {
            (Some(index), _) => name(*index),
            (None, Some(only)) => self.name_of_entry(only),
            (None, None) => String::new(),
        }
    }

    /// `DataTypes` with basic types first, then enumerations, then composite types by index.
    pub(super) fn declarations(&self, device: &Device) -> Element {
        let basic: BTreeMap<_, _> = device
            .objects
            .iter()
            .flat_map(|object| &object.entries)
            .map(|entry| (primitive::order(entry.data_type), primitive::declaration(entry.data_type)))
            .collect();
        let numbered = self.enumerations.iter().enumerate();
        Element::new("DataTypes")
            .children(basic.into_values())
            .children(numbered.map(|(number, enumeration)| enumeration.declaration(number)))
            .children(self.composites.values().flatten().cloned())
    }

    fn name_of_entry(&self, entry: &Entry) -> String {
        let enumeration = Enumeration::of(entry);
        let mut known = self.enumerations.iter().enumerate();
        match known.find(|(_, known)| Some(*known) == enumeration.as_ref()) {
            Some((number, enumeration)) => enumeration.name(number),
            None => primitive::name(entry.data_type),
        }
    }

    /// The declarations of an object's composite type under the name of `index`; none if it holds one value.
    fn composite(&self, object: &Object, index: Index) -> Vec<Element> {
        let Some(shape) = Shape::of(object) else { return Vec::new() };
        let composite = |members: Vec<Element>| {
            Element::new("DataType")
                .child(Element::leaf("Name", name(index)))
                .child(Element::leaf("BitSize", shape.bits()))
                .children(members)
        };
        match &shape {
            Shape::Var(_) => Vec::new(),
            Shape::Record(members) => {
                vec![composite(members.iter().map(|member| self.sub_item(member)).collect())]
            }
            Shape::Array { count, elements } => {
                let array = format!("{}ARR", name(index));
                let mut declarations = Vec::new();
                if let Some(first) = elements.first() {
                    let bits = shape.bits().saturating_sub(first.offset);
                    declarations.push(self.array(&array, first.entry, elements.len(), bits));
                    declarations
                        .push(composite(vec![self.sub_item(count), all_elements(&array, first, bits)]));
                }
                declarations
            }
        }
    }

    fn sub_item(&self, member: &Member<'_>) -> Element {
        let entry = member.entry;
        Element::new("SubItem")
            .child(Element::leaf("SubIdx", entry.address.subindex))
            .child(Element::leaf("Name", &member.name))
            .child(Element::leaf("Type", self.name_of_entry(entry)))
            .children(comment([&entry.about, &entry.note]))
            .child(Element::leaf("BitSize", entry.data_type.bits()))
            .child(Element::leaf("BitOffs", member.offset))
            .child(flags::of_entry(entry))
    }

    fn array(&self, name: &str, element: &Entry, elements: usize, bits: u32) -> Element {
        Element::new("DataType")
            .child(Element::leaf("Name", name))
            .child(Element::leaf("BaseType", self.name_of_entry(element)))
            .child(Element::leaf("BitSize", bits))
            .child(
                Element::new("ArrayInfo")
                    .child(Element::leaf("LBound", 1))
                    .child(Element::leaf("Elements", elements)),
            )
    }
}

/// All elements of an array as one member: it has no subindex.
fn all_elements(array: &str, first: &Member<'_>, bits: u32) -> Element {
    Element::new("SubItem")
        .child(Element::leaf("Name", "Elements"))
        .child(Element::leaf("Type", array))
        .child(Element::leaf("BitSize", bits))
        .child(Element::leaf("BitOffs", first.offset))
        .child(flags::of_entry(first.entry))
}

/// What people should know, in one comment.
pub(super) fn comment<'a>(texts: impl IntoIterator<Item = &'a Option<String>>) -> Option<Element> {
    let mut parts: Vec<String> = Vec::new();
    for text in texts.into_iter().flatten().map(|text| prose(text)) {
        if !parts.contains(&text) {
            parts.push(text);
        }
    }
    (!parts.is_empty()).then(|| Element::worded("Comment", parts.join(" ")))
}

fn name(index: Index) -> String {
    format!("DT{:04X}", index.0)
}

/// The object of the first axis that this one repeats; itself if it repeats none.
fn first_of_its_kind(device: &Device, object: &Object) -> Index {
    let Some(axis) = object.axis.filter(|axis| *axis > 0) else { return object.index };
    let shifts = device.shifts.iter().filter_map(|shift| {
        let distance = shift.by.checked_mul(axis.into())?;
        let first = Index(object.index.0.checked_sub(distance)?);
        (shift.first <= first && first <= shift.last).then_some(first)
    });
    let firsts = shifts.filter_map(|index| device.object(index)).filter(|first| first.id == object.id);
    firsts.map(|first| first.index).next().unwrap_or(object.index)
}
