//! How sure an area of the dictionary is, in marks with a legend below.

use std::collections::BTreeSet;

use super::is_mapping;
use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{link, small};
use crate::model::{Category, Entry, Object, Place, Provenance, provenance};

/// The profile says so, and the description of the device nothing else.
const PROFILE: &str = "†";
/// No source says so.
const ASSUMED: &str = "‡";
/// Nobody has to say so.
const DERIVED: &str = "§";

/// The marks that an area has used.
#[derive(Debug, Default)]
pub(super) struct Marks {
    /// Whether all types are the profile's: that is said once and not marked.
    all_types: bool,
    used: BTreeSet<&'static str>,
}

impl Marks {
    /// The marks for these objects.
    pub(super) fn new(context: &Context<'_>, objects: &[&Object]) -> Self {
        let shown = objects.iter().filter(|object| !is_mapping(context, object));
        let mut entries = shown.flat_map(|object| &object.entries).peekable();
        let all_types = entries.peek().is_some()
            && entries.all(|entry| provenance(&entry.origin, "type") != Provenance::Stated)
            && objects.iter().any(|object| !object.derived);
        Self { all_types, used: BTreeSet::new() }
    }

    /// What is to be marked of an object.
    pub(super) fn object(&mut self, context: &Context<'_>, object: &Object) -> String {
        let at = Place::from(object.index);
        let about = |place: &Place| (place.section, &place.key) == (at.section, &at.key);
        let assumed = context.device.assumptions.iter().any(|assumption| about(&assumption.at));
        let provenance = match provenance(&object.origin, "name") {
            _ if object.derived => Some(DERIVED),
            Provenance::Profile => Some(PROFILE),
            _ => None,
        };
        let marks = provenance.into_iter().chain(assumed.then_some(ASSUMED));
        marks.map(|mark| self.mark(mark)).collect()
    }

    /// What is to be marked of the type of an entry.
    pub(super) fn data_type(&mut self, entry: &Entry) -> String {
        let marked = provenance(&entry.origin, "type") == Provenance::Profile && !self.all_types;
        if marked { self.mark(PROFILE) } else { String::new() }
    }

    /// Whether a profile demands an entry, in a letter.
    pub(super) fn category(&mut self, category: Category) -> String {
        let letter = match category {
            Category::Optional => return String::new(),
            Category::Mandatory => "m",
            Category::Conditional => "c",
        };
        self.used.insert(letter);
        letter.into()
    }

    fn mark(&mut self, mark: &'static str) -> String {
        self.used.insert(mark);
        format!("<sup>{mark}</sup>")
    }

    /// What the marks mean that have been used.
    pub(super) fn legend(&self) -> String {
        let assumption = format!("{ASSUMED} an {}", link("assumption", "sources"));
        let meanings = [
            (PROFILE, "† the profile's, where the description of the device states none of its own"),
            (ASSUMED, &*assumption),
            (DERIVED, "§ follows from the PDOs or the number of entries"),
            ("m", "m demanded by the profile"),
            ("c", "c demanded by the profile on a condition"),
        ];
        let used = meanings.iter().filter(|(mark, _)| self.used.contains(mark)).map(|(_, meaning)| *meaning);
        let types = self.all_types.then_some("All types are those of the profile");
        small(&types.into_iter().chain(used).collect::<Vec<_>>().join(" · "))
    }
}

/// Whether a profile demands a single value, be it said of the object or of its entry.
pub(super) fn demanded(object: &Object, entry: &Entry) -> Category {
    if object.category == Category::Optional { entry.category } else { object.category }
}
