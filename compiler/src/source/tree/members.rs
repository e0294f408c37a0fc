//! The members of a table, found by their keys however many there are.

use std::cmp::Ordering;
use std::ops::Deref;
use std::sync::{Arc, OnceLock};
use std::{slice, vec};

use super::{CanonicalKey, Layer, Member, Node, Value};
use crate::source::keys::range;

/// Tables up to this size are searched from the front, which is faster and needs no memory.
const FEW: usize = 8;

/// Members in the order in which they were written, each key once.
#[derive(Debug, Default)]
pub struct Members {
    list: Vec<Member>,
    /// The keys that were taken out because they do not hold, and who says so.
    gone: Vec<(Arc<str>, Layer)>,
    /// The places of the members by key, made when a large table is asked for the first time; what changes the list
    /// forgets it.
    by_key: OnceLock<Box<[usize]>>,
    /// What they weigh with all that is in them, summed up when it is asked for the first time.
    weight: OnceLock<usize>,
}

/// What a value costs besides its text.
const NODE: usize = 32;

impl Members {
    /// The place of the member of this name, in whatever spelling of a number.
    pub fn place(&self, name: &str) -> Option<usize> {
        let meant = range::<i64>(name).map(|range| (*range.start(), *range.end()));
        let order = |member: &Member| match (&member.key.canonical, meant) {
            (CanonicalKey::Range(first, last), Some(meant)) => (*first, *last).cmp(&meant),
            (CanonicalKey::Word(word), None) => (**word).cmp(name),
            (CanonicalKey::Range(..), None) => Ordering::Less,
            (CanonicalKey::Word(_), Some(_)) => Ordering::Greater,
        };
        if self.list.len() <= FEW {
            return self.list.iter().position(|member| match (&member.key.canonical, meant) {
                (CanonicalKey::Range(first, last), Some(meant)) => (*first, *last) == meant,
                (CanonicalKey::Word(word), None) => **word == *name,
                _ => false,
            });
        }
        let places = self.by_key.get_or_init(|| by_key(&self.list));
        let found = places.binary_search_by(|place| self.list.get(*place).map_or(Ordering::Less, order));
        found.ok().and_then(|found| places.get(found)).copied()
    }

    /// Adds a member behind all others.
    pub fn push(&mut self, member: Member) {
        self.changed().push(member);
    }

    /// Takes out the members that are not wanted, since they do not hold; who says so is `layer`.
    pub fn take_away(&mut self, layer: Layer, unwanted: impl Fn(&Member) -> bool) {
        let gone = self.list.iter().filter(|member| unwanted(member));
        let gone: Vec<_> = gone.map(|member| (Arc::clone(&member.key.name), layer)).collect();
        self.gone.extend(gone);
        self.retain(|member| !unwanted(member));
    }

    /// The keys that were taken out because they do not hold, each with who says so.
    pub fn gone(&self) -> &[(Arc<str>, Layer)] {
        &self.gone
    }

    /// These members, with what was taken out of others.
    #[must_use]
    pub(super) fn without_those_of(mut self, others: &Self) -> Self {
        self.gone.extend(others.gone.iter().cloned());
        self
    }

    /// Takes a member out by its place.
    pub fn remove(&mut self, place: usize) -> Option<Member> {
        (place < self.list.len()).then(|| self.changed().remove(place))
    }

    /// Keeps the members that are wanted.
    pub fn retain(&mut self, wanted: impl FnMut(&Member) -> bool) {
        self.changed().retain(wanted);
    }

    /// The members, to be changed.
    pub fn iter_mut(&mut self) -> slice::IterMut<'_, Member> {
        self.changed().iter_mut()
    }

    /// The member at a place, to be changed.
    pub fn get_mut(&mut self, place: usize) -> Option<&mut Member> {
        self.changed().get_mut(place)
    }

    /// The members as they are.
    pub fn as_slice(&self) -> &[Member] {
        &self.list
    }

    /// About how many bytes the members are as text, each counted as often as it is there: what tables share weighs
    /// on each of them.
    pub(crate) fn weight(&self) -> usize {
        *self.weight.get_or_init(|| {
            let weights = self.list.iter().map(|member| member.key.name.len() + weight(&member.node));
            weights.fold(0, usize::saturating_add)
        })
    }

    fn changed(&mut self) -> &mut Vec<Member> {
        self.by_key.take();
        self.weight.take();
        &mut self.list
    }
}

fn weight(node: &Node) -> usize {
    let inside = match &node.value {
        Value::String(text) => text.len(),
        Value::Array(items) => items.iter().map(weight).fold(0, usize::saturating_add),
        Value::Table(table) => table.members.weight(),
        _ => 0,
    };
    inside.saturating_add(NODE)
}

fn by_key(list: &[Member]) -> Box<[usize]> {
    let mut places: Vec<(&CanonicalKey, usize)> =
        list.iter().map(|member| &member.key.canonical).zip(0..).collect();
    places.sort_unstable();
    places.into_iter().map(|(_, place)| place).collect()
}

impl Deref for Members {
    type Target = [Member];

    fn deref(&self) -> &[Member] {
        &self.list
    }
}

impl Clone for Members {
    fn clone(&self) -> Self {
        Self { gone: self.gone.clone(), ..self.list.clone().into() }
    }
}

impl PartialEq for Members {
    fn eq(&self, other: &Self) -> bool {
        self.list == other.list && self.gone == other.gone
    }
}

impl From<Vec<Member>> for Members {
    fn from(list: Vec<Member>) -> Self {
        Self { list, ..Self::default() }
    }
}

impl FromIterator<Member> for Members {
    fn from_iter<I: IntoIterator<Item = Member>>(members: I) -> Self {
        members.into_iter().collect::<Vec<_>>().into()
    }
}

impl Extend<Member> for Members {
    fn extend<I: IntoIterator<Item = Member>>(&mut self, members: I) {
        self.changed().extend(members);
    }
}

impl IntoIterator for Members {
    type Item = Member;
    type IntoIter = vec::IntoIter<Member>;

    fn into_iter(self) -> Self::IntoIter {
        self.list.into_iter()
    }
}

impl<'m> IntoIterator for &'m Members {
    type Item = &'m Member;
    type IntoIter = slice::Iter<'m, Member>;

    fn into_iter(self) -> Self::IntoIter {
        self.list.iter()
    }
}

impl<'m> IntoIterator for &'m mut Members {
    type Item = &'m mut Member;
    type IntoIter = slice::IterMut<'m, Member>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter_mut()
    }
}
