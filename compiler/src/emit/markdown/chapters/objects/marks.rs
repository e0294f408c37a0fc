//! How sure an area of the dictionary is, in marks with a legend below.

use std::collections::BTreeSet;

use super::is_mapping;
use crate::emit::markdown::context::{Context, assumption_id, once};
use crate::emit::markdown::inline::{link, small};
use crate::model::{Category, Entry, Object, Place, Provenance, provenance};
use crate::source::{Layer, Origin};

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
        Self { all_types, ..Self::default() }
    }

    /// What is to be marked of an object as a whole: beside its name.
    pub(super) fn object(&mut self, context: &Context<'_>, object: &Object) -> String {
        if !context.editorial {
            return String::new();
        }
        let at = Place::from(object.index);
        let whole = context.device.assumptions.iter().find(|assumption| assumption.at == at);
        let by_profile = object.origin.layer("name") == Some(Layer::Profile);
        let sign = object.derived.then_some(DERIVED).or_else(|| by_profile.then_some(PROFILE));
        let sign = sign.map(|mark| self.mark(mark)).unwrap_or_default();
        let whole = whole.map(|whole| {
            self.used.insert(ASSUMED);
            format!("<sup>{}</sup>", link(ASSUMED, assumption_id(whole)))
        });
        let keys = ["name", "entries"].map(|key| self.own(context, &object.origin, key));
        sign + &once(whole.into_iter().chain(keys))
    }

    /// What is to be marked of a key of a table, unless its profile says so.
    pub(super) fn own(&mut self, context: &Context<'_>, origin: &Origin, key: &str) -> String {
        if context.is_profile(origin, key) {
            return String::new();
        }
        let mark = context.mark(origin, key);
        if mark.contains(ASSUMED) {
            self.used.insert(ASSUMED);
        }
        mark
    }

    /// What is to be marked of the type of an entry.
    pub(super) fn data_type(&mut self, context: &Context<'_>, entry: &Entry) -> String {
        self.profile(context, entry, "type", self.all_types) + &self.own(context, &entry.origin, "type")
    }

    /// What a cell says by these keys, with marks. Nothing stays nothing, unless an erratum or an assumption says so.
    pub(super) fn fact(
        &mut self,
        context: &Context<'_>,
        entry: &Entry,
        keys: &[&str],
        text: String,
    ) -> String {
        let is_said = |key: &&str| match provenance(&entry.origin, key) {
            Provenance::Corrected(_) => true,
            Provenance::Assumed(_) => !context.is_profile(&entry.origin, key),
            _ => false,
        };
        let text = match text.is_empty() {
            true if context.editorial && keys.iter().any(is_said) => "–".to_owned(),
            true => return text,
            false => text,
        };
        let marks = keys
            .iter()
            .map(|key| self.profile(context, entry, key, false) + &self.own(context, &entry.origin, key));
        text + &once(marks)
    }

    /// The mark of what only the profile says, unless that is said of all.
    fn profile(&mut self, context: &Context<'_>, entry: &Entry, key: &str, is_said: bool) -> String {
        let is_marked = context.editorial && !is_said && context.is_profile(&entry.origin, key);
        if is_marked { self.mark(PROFILE) } else { String::new() }
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
