//! `DataTypes`: every type that an object, a member or another type names.

use std::collections::BTreeMap;

use super::composite::{Member, Shape};
use super::element::Element;
use super::enumeration::Enumeration;
use super::literal::comment;
use super::{flags, primitive};
use crate::model::{Device, Index, Object};

/// The types of a dictionary by name.
#[derive(Debug, Default)]
pub(super) struct Types {
    /// Basic types by their place in the file.
    basic: BTreeMap<(u8, u32), Element>,
    /// Types for values with meanings, in the order of their first use.
    enumerations: Vec<Enumeration>,
    /// Composite types with all that they are made of, by the object they are named after.
    composites: BTreeMap<Index, Vec<Element>>,
    /// The object that the type of an object is named after, for those with a composite type.
    named_after: BTreeMap<Index, Index>,
}

impl Types {
    /// The types of all objects.
    pub(super) fn of(device: &Device) -> Self {
        let mut types = Self::default();
        for object in &device.objects {
            for member in Shape::of(object).members() {
                types.learn(member);
            }
        }
        for object in &device.objects {
            types.compose(object, first_of_its_kind(device, object));
        }
        types
    }

    /// The type of an object.
    pub(super) fn name_of(&self, object: &Object) -> String {
        match (self.named_after.get(&object.index), Shape::of(object)) {
            (None, Shape::Var(only)) => self.name_of_member(&only),
            (index, _) => name(*index.unwrap_or(&object.index)),
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
        let data_type = member.data_type;
        self.basic.entry(primitive::order(data_type)).or_insert_with(|| primitive::declaration(data_type));
        let enumeration = Enumeration::of(member);
        self.enumerations.extend(enumeration.filter(|new| !self.enumerations.contains(new)));
    }

    /// Declares the composite type of an object, if it needs one: that of the object it repeats if it is the
    /// same, else one of its own.
    fn compose(&mut self, object: &Object, first: Index) {
        let shape = Shape::of(object);
        if matches!(shape, Shape::Var(_)) {
            return;
        }
        let same = self.composites.get(&first) == Some(&self.composite(&shape, first));
        let index = if same { first } else { object.index };
        self.named_after.insert(object.index, index);
        if !same {
            self.composites.insert(index, self.composite(&shape, index));
        }
    }

    fn name_of_member(&self, member: &Member<'_>) -> String {
        let enumeration = Enumeration::of(member);
        let mut known = self.enumerations.iter().enumerate();
        match known.find(|(_, known)| Some(*known) == enumeration.as_ref()) {
            Some((number, enumeration)) => enumeration.name(number),
            None => primitive::name(member.data_type),
        }
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
            .child(Element::leaf("Type", self.name_of_member(member)))
            .child(comment([&entry.about, &entry.note]))
            .child(Element::leaf("BitSize", member.data_type.bits()))
            .child(Element::leaf("BitOffs", member.offset))
            .child(flags::of_entry(entry))
    }
}

fn array_info(elements: usize) -> Element {
    Element::new("ArrayInfo").child(Element::leaf("LBound", 1)).child(Element::leaf("Elements", elements))
}

fn name(index: Index) -> String {
    format!("DT{:04X}", index.0)
}

/// The object of the first axis that this one repeats; itself if it repeats none.
fn first_of_its_kind(device: &Device, object: &Object) -> Index {
    let Some(axis) = object.axis.filter(|axis| *axis > 0) else { return object.index };
    let mut firsts = device.shifts.iter().filter_map(|shift| {
        let distance = shift.by.checked_mul(axis.into())?;
        let first = Index(object.index.0.checked_sub(distance)?);
        let repeated = device.object(first).filter(|_| shift.first <= first && first <= shift.last)?;
        (repeated.id == object.id).then_some(first)
    });
    firsts.next().unwrap_or(object.index)
}
