//! What looks like words that nobody knows.

use super::entity::Entity;
use super::find::{named, narrowed};
use super::tree::Trees;
use super::word::{Number, Phrase, numbers};
use crate::rules;
use crate::text::near::nearest;

/// How many words are offered instead of an unknown one.
const MOST: usize = 4;

/// How far a number may be from one that is meant.
const FAR: u64 = 8;

/// What is known and like a phrase: numbers beside it, names that contain it, or names that are spelled like it.
pub(super) fn near(trees: &Trees, phrase: &Phrase) -> Vec<String> {
    let elsewhere = elsewhere(trees, phrase);
    let (entities, phrase) = narrowed(trees, phrase);
    let mut near = match phrase.number() {
        _ if !elsewhere.is_empty() => elsewhere,
        _ if phrase.text().is_empty() => Vec::new(),
        Some(number) => beside(&entities, number),
        None => alike(trees, &entities, &phrase),
    };
    near.truncate(MOST);
    near
}

/// What other trees have under the name of one that does not.
fn elsewhere(trees: &Trees, phrase: &Phrase) -> Vec<String> {
    let Some(rest) = trees.names().find_map(|name| phrase.behind(name)) else { return Vec::new() };
    let (entities, rest) = narrowed(trees, &rest);
    named(&entities, &rest).iter().map(Entity::title).collect()
}

/// What has a number beside this one, the nearest first.
fn beside(entities: &[Entity<'_>], number: Number) -> Vec<String> {
    let known = entities.iter().filter(|entity| entity.is_written_as(number)).filter_map(|entity| {
        let distance = numbers(entity.key)?.start().abs_diff(number.value);
        (distance <= FAR).then(|| (distance, entity.title()))
    });
    let mut known: Vec<(u64, String)> = known.collect();
    known.sort_by_key(|(distance, _)| *distance);
    known.into_iter().map(|(_, title)| title).collect()
}

/// What has the phrase in one of its names, or else a name like it; each by the first of its names.
fn alike(trees: &Trees, entities: &[Entity<'_>], phrase: &Phrase) -> Vec<String> {
    let all: Vec<Vec<&str>> = entities.iter().map(|entity| entity.names().collect()).collect();
    let others = trees.names().chain(rules::all().into_iter().map(|rule| rule.name)).map(|name| vec![name]);
    let all: Vec<Vec<&str>> = all.into_iter().chain(others).collect();
    let mut found: Vec<&str> = all.iter().flatten().copied().filter(|name| phrase.is_in(name)).collect();
    if found.is_empty() {
        found = nearest(phrase.text(), all.iter().flatten().copied());
    }
    let mut offered: Vec<String> = Vec::new();
    for name in found {
        let owner = all.iter().find(|names| names.contains(&name));
        let first = owner.and_then(|names| names.first()).copied().unwrap_or(name);
        if !offered.iter().any(|offered| offered == first) {
            offered.push(first.to_owned());
        }
    }
    offered
}
