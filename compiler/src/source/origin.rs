//! Where an entity was written.

use std::fmt;
use std::sync::Arc;

use super::{Location, Node, Table, Value};

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

    /// Where the entity is named.
    pub fn header(&self) -> Location {
        self.header
    }

    /// Where the value at `path` was set (`"max"`, `"entries.0x01.type"`); the header if nothing set it.
    pub fn value(&self, path: &str) -> Location {
        self.node(path).map_or(self.header, |node| node.at)
    }

    /// Whether the value at `path` was set.
    pub fn has(&self, path: &str) -> bool {
        self.node(path).is_some()
    }

    /// The value of the layer below at `path`, if the description replaced it by its own: a profile's, or one
    /// of its own that differs for a member of a family or on an axis.
    pub fn under(&self, path: &str) -> Option<&Node> {
        match path.rsplit_once('.') {
            None => self.table.get(path)?.under.as_deref(),
            Some((table, key)) => self.node(table)?.table()?.get(key)?.under.as_deref(),
        }
    }

    /// The value at `path`, if one was set.
    pub fn node(&self, path: &str) -> Option<&Node> {
        let mut parts = path.split('.');
        let mut node = &self.table.get(parts.next()?)?.node;
        for part in parts {
            node = match &node.value {
                Value::Table(table) => &table.get(part)?.node,
                Value::Array(items) => items.get(part.parse::<usize>().ok()?)?,
                _ => return None,
            };
        }
        Some(node)
    }
}

/// The place alone: the table is what the entity itself says.
impl fmt::Debug for Origin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Location { file, start, end } = self.header;
        write!(f, "Origin({}:{start}..{end})", file.0)
    }
}
