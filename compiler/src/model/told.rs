//! Whether two parts of the model are one, so that they can be told once.

use super::{Beside, Compare, Device, Document, Erratum, Provenance, Source, differences, facts_of_type};
use crate::source::Origin;

/// Two devices, parts of which are held against each other: with them are the documents that sources name, and the errata.
#[derive(Debug, Clone, Copy)]
pub struct Pair<'a> {
    first: &'a Device,
    second: &'a Device,
    /// Whether they have the same errata, with the same numbers.
    has_same_errata: bool,
}

impl<'a> Pair<'a> {
    /// Two devices.
    pub fn of(first: &'a Device, second: &'a Device) -> Self {
        let told = |errata: &'a [Erratum]| errata.iter().map(|erratum| (&erratum.says, &erratum.why));
        let has_same_errata = told(&first.errata).eq(told(&second.errata));
        Self { first, second, has_same_errata }
    }

    /// Whether nothing differs between a part of the first device and one of the second: neither what they say, nor who
    /// says it.
    pub fn is_one<T: Compare>(&self, first: &T, second: &T) -> bool {
        (first == second || differences(first, second).is_empty()) && first.is_told_alike(second, self)
    }

    fn is_same_erratum(&self, first: u16, second: u16) -> bool {
        let told = |erratum: &'a Erratum| (&erratum.says, &erratum.why);
        let in_first = self.first.errata.get(usize::from(first)).map(told);
        in_first == self.second.errata.get(usize::from(second)).map(told)
    }
}

impl<'a> Beside for Pair<'a> {
    fn is_same_source(&self, first: &Source, second: &Source) -> bool {
        let in_device = |device: &'a Device, source: &Source| {
            let documents = &device.documents;
            let named = source.document.as_ref().map(|id| documents.iter().position(|one| one.id == *id));
            let place = named.unwrap_or((!documents.is_empty()).then_some(0));
            place
                .and_then(|place| documents.get(place))
                .map(|document: &Document| (document, place == Some(0)))
        };
        match (in_device(self.first, first), in_device(self.second, second)) {
            (Some((one, is_main)), Some((other, is_other_main))) => {
                is_main == is_other_main && (&one.number, &one.title) == (&other.number, &other.title)
            }
            (None, None) => true,
            _ => false,
        }
    }

    fn is_same_author(&self, first: &Origin, second: &Origin) -> bool {
        // most is written once for both, so that there is no need to look into it
        if self.has_same_errata && first == second {
            return true;
        }
        let (of_first, of_second) = (facts_of_type(first), facts_of_type(second));
        of_first.len() == of_second.len()
            && of_first.iter().zip(&of_second).all(|((path, who), (other, by))| {
                path == other
                    && match (who, by) {
                        (Provenance::Corrected(one), Provenance::Corrected(other))
                        | (Provenance::Contradicted(one), Provenance::Contradicted(other)) => {
                            self.is_same_erratum(*one, *other)
                        }
                        (who, by) => who == by,
                    }
            })
    }
}
