//! How sure an area of the dictionary is, in marks with a legend below.

use std::collections::BTreeSet;

use super::is_mapping;
use crate::emit::markdown::context::{Context, assumption_id};
use crate::emit::markdown::inline::{link, small};
use crate::model::{Category, Entry, Object, Place, Provenance, provenance};
use crate::source::Origin;

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
        if !context.editorial {
            return String::new();
        }
        let at = Place::from(object.index);
        let assumed = context.device.assumptions.iter().find(|assumption| assumption.at == at);
        let assumed = assumed.map(|assumption| {
            self.used.insert(ASSUMED);
            format!("<sup>{}</sup>", link(ASSUMED, assumption_id(assumption)))
        });
        let provenance = match provenance(&object.origin, "name") {
            _ if object.derived => Some(DERIVED),
            Provenance::Profile => Some(PROFILE),
            _ => None,
        };
        let provenance = provenance.map(|mark| self.mark(mark));
        provenance.into_iter().chain(assumed).collect()
    }

    /// What is to be marked of the type of an entry.
    pub(super) fn data_type(&mut self, context: &Context<'_>, entry: &Entry) -> String {
        match provenance(&entry.origin, "type") {
            Provenance::Profile if self.all_types => String::new(),
            _ => self.of(context, &entry.origin, "type"),
        }
    }

    /// What a cell says by these keys, with marks; nothing stays nothing.
    pub(super) fn fact(
        &mut self,
        context: &Context<'_>,
        entry: &Entry,
        keys: &[&str],
        text: String,
    ) -> String {
        if text.is_empty() {
            return text;
        }
        let mut marks: Vec<String> = keys.iter().map(|key| self.of(context, &entry.origin, key)).collect();
        marks.dedup();
        text + &marks.concat()
    }

    fn of(&mut self, context: &Context<'_>, origin: &Origin, key: &str) -> String {
        match provenance(origin, key) {
            Provenance::Profile if context.editorial => self.mark(PROFILE),
            Provenance::Assumed(_) if context.editorial => {
                self.used.insert(ASSUMED);
                context.mark(origin, key)
            }
            _ => context.mark(origin, key),
        }
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
