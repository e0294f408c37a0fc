//! Types for values with meanings.

use super::composite::Member;
use super::element::Element;
use super::literal::prose;
use super::primitive;
use crate::model::{DataType, Meaning};

/// The values that the schema takes for an enumeration.
const VALUES: std::ops::RangeInclusive<i64> = 0..=0xFFFF_FFFF;

/// The first of the indices that ETG.1020 keeps for enumerations; types are named after them.
const FIRST: usize = 0x0800;

/// A basic type of which some values have a meaning.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Enumeration {
    /// The type below.
    pub(super) base: DataType,
    meanings: Vec<Meaning>,
}

impl Enumeration {
    /// The type of a value, if it is a choice: at least two of its values have meanings, and its type is one of those that
    /// ETG.2000 lets be an enumeration.
    pub(super) fn of(member: &Member<'_>) -> Option<Self> {
        let base = member.data_type;
        if !matches!(base, DataType::Bool | DataType::Uint(8 | 16 | 32) | DataType::Bits(_)) {
            return None;
        }
        let fits = |value| {
            VALUES.contains(&value)
                && base.range().is_some_and(|(min, max)| (min..=max).contains(&value.into()))
        };
        let meanings: Vec<_> =
            member.entry.values.iter().filter(|meaning| fits(meaning.value)).cloned().collect();
        (meanings.len() > 1).then_some(Self { base, meanings })
    }

    /// The name of the enumeration that is the `number`th in its dictionary, as `DT0800EN08`.
    pub(super) fn name(&self, number: usize) -> String {
        format!("DT{:04X}EN{:02}", FIRST.saturating_add(number), self.base.bits())
    }

    /// The type below; a few bits are part of a byte.
    fn base_name(&self) -> String {
        match self.base {
            DataType::Bits(_) => primitive::name(DataType::Uint(8)),
            base => primitive::name(base),
        }
    }

    /// The declaration.
    pub(super) fn declaration(&self, number: usize) -> Element {
        Element::new("DataType")
            .child(Element::leaf("Name", self.name(number)))
            .child(Element::leaf("BaseType", self.base_name()))
            .child(Element::leaf("BitSize", self.base.bits()))
            .children(self.meanings.iter().map(meaning))
    }
}

fn meaning(meaning: &Meaning) -> Element {
    Element::new("EnumInfo")
        .children(Element::in_languages("Text", &meaning.name, &meaning.names))
        .child(Element::leaf("Enum", meaning.value))
        .child(meaning.about.as_deref().map(|about| Element::worded("Comment", prose(about))))
}
