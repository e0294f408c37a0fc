//! How the values of an object lie one behind the other.

use std::collections::BTreeSet;

use crate::model::{DataType, Entry, Kind, Object};

/// The type of subindex 0 beside other values, as ETG.1000.6 fixes it. What a description says instead would
/// shift all that follows.
const COUNT: DataType = DataType::Uint(8);

/// The bit at which what follows subindex 0 starts: a byte is left free behind it.
const FIRST_MEMBER: u32 = 16;

/// What an object looks like to a tool.
#[derive(Debug)]
pub(super) enum Shape<'a> {
    /// One value.
    Var(Member<'a>),
    /// Subindex 0, and elements that are alike in all but name, limits and default.
    Array(Vec<Member<'a>>),
    /// Members that differ, subindex 0 first.
    Record(Vec<Member<'a>>),
}

/// A value of an object.
#[derive(Debug)]
pub(super) struct Member<'a> {
    /// What is said of it.
    pub(super) entry: &'a Entry,
    /// Its name, unique among its siblings.
    pub(super) name: String,
    /// Its type.
    pub(super) data_type: DataType,
    /// The first bit within the object.
    pub(super) offset: u32,
}

impl<'a> Shape<'a> {
    /// The shape of an object; a record of nothing if it has no entries.
    pub(super) fn of(object: &'a Object) -> Self {
        match object.entries.as_slice() {
            [entry] => {
                let (name, data_type) = (entry.name.clone(), entry.data_type);
                Self::Var(Member { entry, name, data_type, offset: 0 })
            }
            entries if object.kind == Kind::Array && alike(entries) => Self::Array(layout(entries)),
            entries => Self::Record(layout(entries)),
        }
    }

    /// All values by subindex.
    pub(super) fn members(&self) -> &[Member<'a>] {
        match self {
            Self::Var(only) => std::slice::from_ref(only),
            Self::Array(members) | Self::Record(members) => members,
        }
    }

    /// The width in bits, for several values in whole bytes.
    pub(super) fn bits(&self) -> u32 {
        match self {
            Self::Var(only) => only.data_type.bits(),
            Self::Array(members) | Self::Record(members) => {
                members.last().map_or(0, Member::end).next_multiple_of(8)
            }
        }
    }
}

impl Member<'_> {
    /// The first bit behind it.
    pub(super) fn end(&self) -> u32 {
        self.offset.saturating_add(self.data_type.bits())
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
                && one.safety == other.safety
                && one.category == other.category
                && one.written == other.written
                && (one.backup, one.setting) == (other.backup, other.setting)
                && one.values == other.values
        })
}

/// Puts entries one behind the other: single bits side by side, all else at the next whole byte.
fn layout(entries: &[Entry]) -> Vec<Member<'_>> {
    let mut names = BTreeSet::new();
    let mut members: Vec<Member<'_>> = Vec::with_capacity(entries.len());
    for entry in entries {
        let data_type = if entry.address.subindex == 0 { COUNT } else { entry.data_type };
        let free = match members.as_slice() {
            [] => 0,
            [count] => count.end().max(FIRST_MEMBER),
            [.., last] => last.end(),
        };
        let offset = if data_type.bits() < 8 { free } else { free.next_multiple_of(8) };
        members.push(Member { entry, name: unique(entry, &mut names), data_type, offset });
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
