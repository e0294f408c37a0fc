//! `Comment`: what people should know of an object or an entry.

use super::composite::{Member, Shape};
use super::element::Element;
use super::enumeration::Enumeration;
use super::literal::prose;
use crate::model::Object;

/// What a description says by `functional = false`.
const WITHOUT_FUNCTION: &str = "Without function; exists for compatibility only.";

/// What is to be said of an object, with what its type has no place for: of its value if it has but one, of its elements
/// if they share a type.
pub(super) fn of_object(object: &Object, shape: &Shape<'_>) -> Option<Element> {
    let own = [object.about.clone(), object.note.clone(), without_function(object.functional)];
    let own = own.into_iter().flatten();
    match shape {
        Shape::Var(only) => comment(own.chain(texts(only)).chain(values(only))),
        Shape::Array(members) => comment(own.chain(elements(members.get(1..).unwrap_or_default()))),
        Shape::Record(_) => comment(own),
    }
}

/// What is to be said of an entry among others.
pub(super) fn of_entry(member: &Member<'_>) -> Option<Element> {
    let idle = without_function(member.entry.functional);
    comment(texts(member).chain(idle).chain(values(member)))
}

fn texts(member: &Member<'_>) -> impl Iterator<Item = String> {
    [member.entry.about.clone(), member.entry.note.clone()].into_iter().flatten()
}

/// What is to be said of the elements of an array: once if it is the same of all, else each with its name.
fn elements(members: &[Member<'_>]) -> Vec<String> {
    let said = |member: &Member<'_>| -> Vec<String> {
        texts(member).chain(without_function(member.entry.functional)).collect()
    };
    let Some(first) = members.first() else { return Vec::new() };
    let mut all = match members.iter().all(|member| said(member) == said(first)) {
        true => said(first),
        false => members
            .iter()
            .filter(|member| !said(member).is_empty())
            .map(|member| format!("{}: {}", member.name, said(member).join(" ")))
            .collect(),
    };
    all.extend(values(first));
    all
}

/// What single values mean, where the type cannot say it.
fn values(member: &Member<'_>) -> Option<String> {
    let values = &member.entry.values;
    let untold = values.iter().next().is_some() && Enumeration::of(member).is_none();
    untold.then(|| {
        let values = values.iter().map(|meaning| format!("{} = {}", meaning.value, meaning.name));
        format!("Values: {}.", values.collect::<Vec<_>>().join("; "))
    })
}

fn without_function(functional: bool) -> Option<String> {
    (!functional).then(|| WITHOUT_FUNCTION.to_owned())
}

/// All texts in one comment, each once.
fn comment(texts: impl IntoIterator<Item = String>) -> Option<Element> {
    let mut parts: Vec<String> = Vec::new();
    for text in texts.into_iter().map(|text| prose(&text)) {
        if !parts.contains(&text) {
            parts.push(text);
        }
    }
    (!parts.is_empty()).then(|| Element::worded("Comment", parts.join(" ")))
}
