//! What a phrase is about.

use super::entity::Entity;
use super::noun::noun;
use super::relation::word;
use super::tree::{Tree, Trees};
use super::word::Phrase;
use crate::source::Member;

/// Something that there is an answer to.
pub(super) enum Found<'t> {
    /// A whole tree.
    Tree(&'t Tree),
    /// All things of a section of a tree.
    Section(Vec<Entity<'t>>),
    /// One thing.
    Entity(Entity<'t>),
    /// An entry of an object.
    Entry(Entity<'t>, &'t Member),
}

/// All that a phrase can mean.
pub(super) fn find<'t>(trees: &'t Trees, phrase: &Phrase) -> Vec<Found<'t>> {
    if phrase.text().is_empty() {
        return Vec::new();
    }
    let everywhere: Vec<Entity<'t>> = Entity::everywhere(trees).collect();
    let found = among(&everywhere, phrase);
    if !found.is_empty() {
        return found;
    }
    if let Some(tree) = trees.trees.iter().find(|tree| phrase.is(&tree.name)) {
        return vec![Found::Tree(tree)];
    }
    let (entities, rest) = narrowed(trees, phrase);
    match rest.text() {
        "" => sections(&entities).into_iter().map(Found::Section).collect(),
        _ => among(&entities, &rest),
    }
}

/// What is left of all things and of a phrase if the name of a tree in front, and then that of a section or of one of
/// its things, narrow the question.
pub(super) fn narrowed<'t>(trees: &'t Trees, phrase: &Phrase) -> (Vec<Entity<'t>>, Phrase) {
    let tree = trees.trees.iter().find_map(|tree| Some((tree, phrase.behind(&tree.name)?)));
    let (entities, phrase): (Vec<Entity<'t>>, Phrase) = match tree {
        Some((tree, rest)) => (Entity::all(tree).collect(), rest),
        None => (Entity::everywhere(trees).collect(), phrase.clone()),
    };
    if !among(&entities, &phrase).is_empty() {
        return (entities, phrase);
    }
    let behind =
        |entity: &Entity<'_>| phrase.behind(entity.section).or_else(|| phrase.behind(&noun(entity.section)));
    // People say `abort` and `al` for short.
    let short = |entity: &Entity<'_>| phrase.behind(entity.section.split('-').next()?);
    let named = |behind: &dyn Fn(&Entity<'_>) -> Option<Phrase>| {
        entities.iter().find_map(|entity| Some((entity.section, behind(entity)?)))
    };
    let found = named(&behind).or_else(|| named(&short));
    match found {
        Some((section, rest)) => (entities.into_iter().filter(|it| it.section == section).collect(), rest),
        None => (entities, phrase),
    }
}

/// Things by section and tree.
fn sections<'t>(entities: &[Entity<'t>]) -> Vec<Vec<Entity<'t>>> {
    let is_same = |a: &Entity<'_>, b: &Entity<'_>| a.section == b.section && a.tree.name == b.tree.name;
    entities.chunk_by(is_same).map(<[Entity<'t>]>::to_vec).collect()
}

/// The things that a phrase names, by a number or by a word.
fn among<'t>(entities: &[Entity<'t>], phrase: &Phrase) -> Vec<Found<'t>> {
    if let Some((object, subindex)) = phrase.entry() {
        let objects = named(entities, &object).into_iter();
        return objects.filter_map(|object| Some(Found::Entry(object, object.entry(subindex)?))).collect();
    }
    let mut found = named(entities, phrase);
    // who asks for an object sees the bits of its word with it
    let words: Vec<Entity<'t>> = found.iter().filter_map(|entity| word(*entity, None)).collect();
    found.retain(|entity| !words.iter().any(|word| std::ptr::eq(word.table, entity.table)));
    found.into_iter().map(Found::Entity).collect()
}

/// The things that a phrase names as a whole.
pub(super) fn named<'t>(entities: &[Entity<'t>], phrase: &Phrase) -> Vec<Entity<'t>> {
    let Some(number) = phrase.number() else {
        return entities.iter().filter(|entity| entity.is(phrase)).copied().collect();
    };
    let all: Vec<Entity<'t>> = entities.iter().filter(|entity| entity.has(number.value)).copied().collect();
    let alike: Vec<Entity<'t>> = all.iter().filter(|entity| entity.is_written_as(number)).copied().collect();
    // an index is never meant for the number of a mode, but people do write error codes in decimal
    if alike.is_empty() || !number.is_hex { all } else { alike }
}
