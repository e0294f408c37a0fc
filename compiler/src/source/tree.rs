//! A parsed TOML file in which every key and every value knows where it stands.
//!
//! The tree is shared, not copied: laying a table over another makes a new list of members that point
//! at the same nodes. So each value still knows the file that really set it, however many layers there are.

mod members;

use std::collections::BTreeMap;
use std::sync::Arc;

use super::Location;
use super::keys::range;
pub use members::Members;

/// A value and its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// Where the value stands; for a table written under a `[header]`, the header.
    pub at: Location,
    /// What it is.
    pub value: Value,
}

/// What a TOML value can be.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// Text.
    String(Arc<str>),
    /// A whole number in whatever radix it was written.
    Integer(i128),
    /// A number with a fraction.
    Float(f64),
    /// `true` or `false`.
    Boolean(bool),
    /// A date, a time, or both, as written.
    Datetime(Arc<str>),
    /// A list.
    Array(Arc<[Node]>),
    /// Keys with values.
    Table(Arc<Table>),
}

/// A key and its place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Key {
    /// The key without quotes.
    pub name: Arc<str>,
    /// Where it stands.
    pub at: Location,
    /// What it stands for.
    pub canonical: CanonicalKey,
}

/// What a key stands for: `0x23` and `35` are two spellings of one key.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum CanonicalKey {
    /// A number, or a range of numbers.
    Range(i64, i64),
    /// A word.
    Word(Arc<str>),
}

/// Who set a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Layer {
    /// A profile.
    Profile,
    /// The description of the device.
    Description,
    /// An erratum in place of what is printed, by its number in the list.
    Corrected(u16),
    /// The description, against an erratum that does not know what holds, by its number in the list.
    Contradicted(u16),
}

/// A key with its value.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// The key.
    pub key: Key,
    /// The value.
    pub node: Node,
    /// Who set it.
    pub layer: Layer,
    /// The value of the lowest of the layers that this one replaced: the profile's, if a profile has one.
    pub under: Option<Arc<Node>>,
}

/// Keys with values, in the order in which they were written.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// The `[header]`, or the braces of an inline table, or the whole file for its root.
    pub at: Location,
    /// The members, each key once.
    pub members: Members,
}

impl Value {
    /// What people call this kind of value, with its article.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::String(_) => "a string",
            Self::Integer(_) => "an integer",
            Self::Float(_) => "a float",
            Self::Boolean(_) => "a boolean",
            Self::Datetime(_) => "a date",
            Self::Array(_) => "an array",
            Self::Table(_) => "a table",
        }
    }
}

impl Key {
    /// A key as it is written at a place.
    pub fn new(name: &str, at: Location) -> Self {
        Self { name: Arc::from(name), at, canonical: CanonicalKey::of(name) }
    }
}

impl CanonicalKey {
    /// What a text stands for as a key.
    pub fn of(name: &str) -> Self {
        match range::<i64>(name) {
            Some(range) => Self::Range(*range.start(), *range.end()),
            None => Self::Word(Arc::from(name)),
        }
    }
}

impl Node {
    /// The table, if this is one.
    pub fn table(&self) -> Option<&Arc<Table>> {
        match &self.value {
            Value::Table(table) => Some(table),
            _ => None,
        }
    }
}

impl Table {
    /// The member of this name, in whatever spelling of a number.
    pub fn get(&self, name: &str) -> Option<&Member> {
        self.members.get(self.position(name)?)
    }

    /// The place among the members of the one of this name.
    pub fn position(&self, name: &str) -> Option<usize> {
        self.members.place(name)
    }

    /// This table laid over `base`: tables merge member by member, everything else in `base` is replaced.
    ///
    /// Members keep the order of `base`, what only this table has follows; the place of the whole is this
    /// table's.
    pub fn over(&self, base: &Table) -> Table {
        let mut own: BTreeMap<&CanonicalKey, &Member> =
            self.members.iter().map(|member| (&member.key.canonical, member)).collect();
        let mut laid = |lower: &Member| {
            own.remove(&lower.key.canonical).map_or_else(|| lower.clone(), |upper| upper.over(lower))
        };
        let mut members: Vec<Member> = base.members.iter().map(&mut laid).collect();
        members.extend(self.members.iter().filter(|member| own.contains_key(&member.key.canonical)).cloned());
        let members = Members::from(members).without_those_of(&base.members).without_those_of(&self.members);
        Table { at: self.at, members }
    }
}

impl Member {
    fn over(&self, base: &Member) -> Member {
        let node = match (&self.node.value, &base.node.value) {
            (Value::Table(upper), Value::Table(lower)) => {
                Node { at: self.node.at, value: Value::Table(Arc::new(upper.over(lower))) }
            }
            _ => self.node.clone(),
        };
        let under = base.under.clone().unwrap_or_else(|| Arc::new(base.node.clone()));
        Member { key: self.key.clone(), node, layer: self.layer, under: Some(under) }
    }
}
