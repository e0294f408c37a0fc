//! `Comment`: what people should know of an object or an entry.

use super::element::Element;
use super::literal::prose;
use crate::model::{Entry, Object};

/// What a description says by `functional = false`.
const WITHOUT_FUNCTION: &str = "Without function; exists for compatibility only.";

/// What is to be said of an object, and of its value if it has but one.
pub(super) fn of_object(object: &Object, only: Option<&Entry>) -> Option<Element> {
    let own = [&object.about, &object.note, &without_function(object.functional)];
    comment(own.into_iter().chain(only.into_iter().flat_map(|entry| [&entry.about, &entry.note])))
}

/// What is to be said of an entry among others.
pub(super) fn of_entry(entry: &Entry) -> Option<Element> {
    comment([&entry.about, &entry.note, &without_function(entry.functional)])
}

fn without_function(functional: bool) -> Option<String> {
    (!functional).then(|| WITHOUT_FUNCTION.to_owned())
}

/// All texts in one comment, each once.
fn comment<'a>(texts: impl IntoIterator<Item = &'a Option<String>>) -> Option<Element> {
    let mut parts: Vec<String> = Vec::new();
    for text in texts.into_iter().flatten().map(|text| prose(text)) {
        if !parts.contains(&text) {
            parts.push(text);
        }
    }
    (!parts.is_empty()).then(|| Element::worded("Comment", parts.join(" ")))
}
