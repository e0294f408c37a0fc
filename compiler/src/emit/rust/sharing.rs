//! Which members of a family have an item just so, and where it stands.
//!
//! An item is the same for two members if nothing differs in the parts of the model that it is made of, by
//! [`Pair::is_one`], and the items that it names are the same. It stands in the module of the family if all members
//! that have an item of its name have this one, else with the first of those that have it.

use std::collections::BTreeMap;

use proc_macro2::Ident;

use super::contents::Contents;
use super::item::{Item, Reach, Space};
use crate::model::{Device, Pair};

/// An item by its module and its name.
type Key = (Space, String);

/// Where an item stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Home {
    /// In the module of the family.
    Family,
    /// In that of a member.
    Member(usize),
}

/// What members share.
#[derive(Debug, Default)]
pub(super) struct Sharing {
    /// For each member and each of its items, the first member that has it just so.
    firsts: Vec<BTreeMap<Key, usize>>,
    /// For each name the items that there are of it: by the first member, all that have it.
    variants: BTreeMap<Key, BTreeMap<usize, Vec<usize>>>,
    /// The items that stand in the module of the family.
    family: BTreeMap<Key, bool>,
}

/// All that is known of the members while they are held against each other.
struct Members<'k, 'a> {
    items: Vec<BTreeMap<Key, &'k Item<'a>>>,
    /// Each with each that comes before it.
    pairs: Vec<Vec<Pair<'k>>>,
}

impl<'k, 'a> Members<'k, 'a> {
    fn of(devices: &'k [Device], contents: &'k [Contents<'a>]) -> Self {
        let items = contents.iter().map(|contents| {
            let items = contents.iter().flat_map(|(space, items)| items.iter().map(|item| (*space, item)));
            items.map(|(space, item)| (key(space, item), item)).collect()
        });
        let with_those_before = |(place, device): (usize, &'k Device)| {
            devices.iter().take(place).map(|first| Pair::of(first, device)).collect()
        };
        let pairs = devices.iter().enumerate().map(with_those_before);
        Self { items: items.collect(), pairs: pairs.collect() }
    }

    fn item(&self, key: &Key, member: usize) -> Option<&'k Item<'a>> {
        self.items.get(member)?.get(key).copied()
    }

    /// Whether a member has the item of one before it, as far as it is made of the model.
    fn are_one(&self, key: &Key, first: usize, member: usize) -> bool {
        let items = self.item(key, first).zip(self.item(key, member));
        let pair = self.pairs.get(member).and_then(|pairs| pairs.get(first));
        items.zip(pair).is_some_and(|((one, other), pair)| {
            other.reach != Reach::Own
                && one.names == other.names
                && one.uses == other.uses
                && one.parts.len() == other.parts.len()
                && one.parts.iter().zip(&other.parts).all(|(one, other)| one.is_one(other, pair))
        })
    }
}

impl Sharing {
    pub(super) fn of(devices: &[Device], contents: &[Contents<'_>]) -> Self {
        let members = Members::of(devices, contents);
        let mut sharing = Self { firsts: vec![BTreeMap::new(); devices.len()], ..Self::default() };
        for (member, items) in members.items.iter().enumerate() {
            for key in items.keys() {
                sharing.settle(key, member, &members);
            }
        }
        for key in members.items.iter().flat_map(BTreeMap::keys) {
            sharing.place(key, &members);
        }
        sharing
    }

    /// Finds the first member that has a member's item just so; none if the member has no such item.
    fn settle(&mut self, key: &Key, member: usize, members: &Members<'_, '_>) -> Option<usize> {
        let settled = self.firsts.get(member)?.get(key);
        if settled.is_some() {
            return settled.copied();
        }
        let item = members.item(key, member)?;
        let uses: Vec<(Key, Option<usize>)> =
            item.uses.iter().map(|used| (named(used), self.settle(&named(used), member, members))).collect();
        let is_same = |first: &usize| {
            uses.iter().all(|(used, settled)| self.known_first(used, *first) == *settled)
                && members.are_one(key, *first, member)
        };
        let mut candidates = self.variants.get(key).into_iter().flat_map(BTreeMap::keys).copied();
        let first = candidates.find(is_same).unwrap_or(member);
        self.firsts.get_mut(member)?.insert(key.clone(), first);
        self.variants.entry(key.clone()).or_default().entry(first).or_default().push(member);
        Some(first)
    }

    /// Finds out whether an item stands in the module of the family.
    fn place(&mut self, key: &Key, members: &Members<'_, '_>) -> bool {
        if let Some(placed) = self.family.get(key) {
            return *placed;
        }
        let only = self.variants.get(key).filter(|variants| variants.len() == 1);
        let first = only.and_then(|variants| variants.iter().find(|(_, holders)| holders.len() > 1));
        let item = first.and_then(|(first, _)| members.item(key, *first));
        let is_there = |used: &Key| members.items.iter().any(|items| items.contains_key(used));
        let placed = item.is_some_and(|item| {
            item.uses.iter().map(named).filter(is_there).all(|used| self.place(&used, members))
        });
        self.family.insert(key.clone(), placed);
        placed
    }

    fn known_first(&self, key: &Key, member: usize) -> Option<usize> {
        self.firsts.get(member)?.get(key).copied()
    }

    /// The first member that has the item just so.
    pub(super) fn first(&self, space: Space, item: &Item<'_>, member: usize) -> usize {
        self.known_first(&key(space, item), member).unwrap_or(member)
    }

    /// All members that have it just so.
    pub(super) fn holders(&self, space: Space, item: &Item<'_>, member: usize) -> Vec<usize> {
        let key = key(space, item);
        let first = self.known_first(&key, member).unwrap_or(member);
        self.variants.get(&key).and_then(|variants| variants.get(&first)).cloned().unwrap_or_default()
    }

    /// Where the item of a member stands.
    pub(super) fn home(&self, space: Space, item: &Item<'_>, member: usize) -> Home {
        let key = key(space, item);
        match self.family.get(&key) {
            Some(true) => Home::Family,
            _ => Home::Member(self.known_first(&key, member).unwrap_or(member)),
        }
    }

    /// How many items of a module stand in the family's.
    pub(super) fn in_family(&self, space: Space) -> usize {
        self.family.iter().filter(|((of, _), placed)| *of == space && **placed).count()
    }
}

fn key(space: Space, item: &Item<'_>) -> Key {
    (space, item.names.first().map(ToString::to_string).unwrap_or_default())
}

fn named((space, name): &(Space, Ident)) -> Key {
    (*space, name.to_string())
}
