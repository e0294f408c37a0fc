//! How the values of an object lie one behind the other.

use std::collections::BTreeSet;

use crate::model::{Entry, Kind, Object};

/// The bit at which what follows subindex 0 starts: a byte is left free behind it.
const FIRST_MEMBER: u32 = 16;

/// What an object looks like to a tool.
#[derive(Debug)]
pub(super) enum Shape<'a> {
    /// One value.
    Var(&'a Entry),
    /// A number of elements that are alike in all but name, limits and default.
    Array {
        /// Subindex 0.
        count: Member<'a>,
        /// The elements.
        elements: Vec<Member<'a>>,
    },
    /// Members that differ.
    Record(Vec<Member<'a>>),
}

/// A value among several.
#[derive(Debug)]
pub(super) struct Member<'a> {
    /// The value.
    pub(super) entry: &'a Entry,
    /// Its name, unique among its siblings.
    pub(super) name: String,
    /// The first bit within the object.
    pub(super) offset: u32,
}

impl<'a> Shape<'a> {
    /// The shape of an object; none if it has no entries at all.
    pub(super) fn of(object: &'a Object) -> Option<Self> {
        match object.entries.as_slice() {
            [] => None,
            [only] => Some(Self::Var(only)),
            entries => {
                let mut members = layout(entries);
                if object.kind == Kind::Array && alike(entries) {
                    let elements = members.split_off(1);
                    members.pop().map(|count| Self::Array { count, elements })
                } else {
                    Some(Self::Record(members))
                }
            }
        }
    }

    /// The members by subindex, if there are several.
    pub(super) fn members(&self) -> impl Iterator<Item = &Member<'a>> {
        let (first, rest): (Option<&Member<'a>>, &[Member<'a>]) = match self {
            Self::Var(_) => (None, &[]),
            Self::Array { count, elements } => (Some(count), elements),
            Self::Record(members) => (None, members),
        };
        first.into_iter().chain(rest)
    }

    /// The width in bits.
    pub(super) fn bits(&self) -> u32 {
        match self {
            Self::Var(entry) => entry.data_type.bits(),
            Self::Array { .. } | Self::Record(_) => self.members().last().map_or(0, Member::end),
        }
    }
}

impl Member<'_> {
    /// The first bit behind it.
    pub(super) fn end(&self) -> u32 {
        self.offset.saturating_add(self.entry.data_type.bits())
    }
}

/// Whether all entries from subindex 1 on, without a gap, are of one type and one access.
fn alike(entries: &[Entry]) -> bool {
    let numbered = (0..).zip(entries).all(|(subindex, entry)| subindex == u16::from(entry.address.subindex));
    let mut pairs = entries.iter().skip(1).zip(entries.iter().skip(2));
    numbered
        && pairs.all(|(one, other)| {
            one.data_type == other.data_type
                && one.access == other.access
                && one.pdo == other.pdo
                && one.category == other.category
                && one.written == other.written
                && one.values == other.values
        })
}

/// Puts entries one behind the other: single bits side by side, all else at the next whole byte.
fn layout(entries: &[Entry]) -> Vec<Member<'_>> {
    let mut names = BTreeSet::new();
    let mut members: Vec<Member<'_>> = Vec::with_capacity(entries.len());
    for entry in entries {
        let free = match members.as_slice() {
            [] => 0,
            [count] => count.end().max(FIRST_MEMBER),
            [.., last] => last.end(),
        };
        let offset = if entry.data_type.bits() < 8 { free } else { free.next_multiple_of(8) };
        members.push(Member { entry, name: unique(entry, &mut names), offset });
    }
    members
}

/// The name of an entry, with its subindex behind it if a sibling has that name already.
fn unique(entry: &Entry, taken: &mut BTreeSet<String>) -> String {
    let mut name = entry.name.clone();
    while !taken.insert(name.clone()) {
        name = format!("{name} ({})", entry.address.subindex);
    }
    name
}
