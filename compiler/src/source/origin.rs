//! Where an entity was written.

use std::fmt;
use std::sync::Arc;

use super::{Layer, Location, Member, Members, Node, Table, Value};

/// The table an entity was read from, kept beside the entity so that a message can point into it.
///
/// The table may be layered: a value that a profile sets lies in the profile's file, one that the device
/// sets lies in the device's.
#[derive(Clone, PartialEq)]
pub struct Origin {
    header: Location,
    table: Arc<Table>,
}

impl Origin {
    /// The origin of an entity whose key stands at `header` and whose values are in `table`.
    pub fn new(header: Location, table: Arc<Table>) -> Self {
        Self { header, table }
    }

    /// The same place for something that follows from the entity, of which its table says nothing.
    #[must_use]
    pub fn header_only(&self) -> Self {
        let at = self.table.at;
        Self { header: self.header, table: Arc::new(Table { at, members: Members::default() }) }
    }

    /// The same for an entity of which what stands under a key says nothing.
    #[must_use]
    pub fn without(&self, key: &str) -> Self {
        if !self.has(key) {
            return self.clone();
        }
        let mut table = Table::clone(&self.table);
        table.members.retain(|member| &*member.key.name != key);
        Self { header: self.header, table: Arc::new(table) }
    }

    /// Where the entity is named.
    pub fn header(&self) -> Location {
        self.header
    }

    /// The table.
    pub fn table(&self) -> &Arc<Table> {
        &self.table
    }

    /// Where the value at `path` was set (`"max"`, `"entries.0x01.type"`); the header if nothing set it.
    pub fn value(&self, path: &str) -> Location {
        self.node(path).map_or(self.header, |node| node.at)
    }

    /// Where the last key of `path` stands, as that of what is set under a name; the header if nothing is.
    pub fn key(&self, path: &str) -> Location {
        self.member(path).map_or(self.header, |member| member.key.at)
    }

    /// About how many bytes all that is said of the entity is.
    pub(crate) fn weight(&self) -> usize {
        self.table.members.weight()
    }

    /// Whether the value at `path` was set.
    pub fn has(&self, path: &str) -> bool {
        self.node(path).is_some()
    }

    /// Who set the value at `path`, or took it away, if anybody did.
    pub fn layer(&self, path: &str) -> Option<Layer> {
        let gone = || self.table.members.gone().iter().find(|(key, _)| &**key == path);
        self.member(path).map(|member| member.layer).or_else(|| gone().map(|(_, layer)| *layer))
    }

    /// The value of the layer below at `path`, if the description replaced it by its own: a profile's, or one
    /// of its own that differs for a member of a family or on an axis.
    pub fn under(&self, path: &str) -> Option<&Node> {
        self.member(path)?.under.as_deref()
    }

    /// The value at `path`, if one was set.
    pub fn node(&self, path: &str) -> Option<&Node> {
        let mut parts = parts(path);
        let node = &self.table.get(parts.next()?)?.node;
        parts.try_fold(node, inner)
    }

    /// The innermost key of `path` with its value; for the element of a list, the key of the list.
    fn member(&self, path: &str) -> Option<&Member> {
        let mut parts = parts(path);
        let member = self.table.get(parts.next()?)?;
        let last = parts.try_fold((member, &member.node), |(member, node), part| {
            let table = node.table();
            match table {
                Some(table) => table.get(part).map(|member| (member, &member.node)),
                None => inner(node, part).map(|node| (member, node)),
            }
        });
        last.map(|(member, _)| member)
    }
}

/// What a table or a list has under a key.
fn inner<'n>(node: &'n Node, key: &str) -> Option<&'n Node> {
    match &node.value {
        Value::Table(table) => table.get(key).map(|member| &member.node),
        Value::Array(items) => items.get(key.parse::<usize>().ok()?),
        _ => None,
    }
}

impl Default for Origin {
    fn default() -> Self {
        let nowhere = Location { file: super::FileId(0), start: 0, end: 0 };
        Self { header: nowhere, table: Arc::new(Table { at: nowhere, members: Members::default() }) }
    }
}

/// The keys of a path; the dots of a range such as `0..=3` are part of its key.
pub(crate) fn parts(path: &str) -> impl Iterator<Item = &str> {
    let mut rest = Some(path);
    std::iter::from_fn(move || {
        let path = rest.take()?;
        let Some(end) = single_dot(path.as_bytes()) else { return Some(path) };
        rest = path.get(end + 1..);
        path.get(..end)
    })
}

/// The place of the first dot with no other beside it.
fn single_dot(bytes: &[u8]) -> Option<usize> {
    let is_dot = |place: Option<usize>| place.and_then(|place| bytes.get(place)) == Some(&b'.');
    let is_single = |place: usize| !is_dot(place.checked_sub(1)) && !is_dot(place.checked_add(1));
    bytes.iter().enumerate().find(|(place, byte)| **byte == b'.' && is_single(*place)).map(|(place, _)| place)
}

/// The place alone: the table is what the entity itself says.
impl fmt::Debug for Origin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Location { file, start, end } = self.header;
        write!(f, "Origin({}:{start}..{end})", file.0)
    }
}
