//! Whether two texts say the same.

use std::collections::BTreeMap;

use super::number::reference;
use crate::source::{CanonicalKey, Node, Table, Value};

/// Whether two tables have the same keys with the same values, in whatever order and spelling.
pub(super) fn same(one: &Table, other: &Table) -> bool {
    let keys = |table: &Table| -> BTreeMap<CanonicalKey, Node> {
        table.members.iter().map(|member| (member.key.canonical.clone(), member.node.clone())).collect()
    };
    let (one, other) = (keys(one), keys(other));
    one.len() == other.len()
        && one
            .iter()
            .zip(&other)
            .all(|((key, node), (other_key, other))| key == other_key && same_node(node, other))
}

fn same_node(one: &Node, other: &Node) -> bool {
    match (&one.value, &other.value) {
        (Value::Table(one), Value::Table(other)) => same(one, other),
        (Value::Array(one), Value::Array(other)) => {
            one.len() == other.len() && one.iter().zip(other.iter()).all(|(one, other)| same_node(one, other))
        }
        (Value::String(one), Value::String(other)) => one == other || is_one_index(one, other),
        (one, other) => one == other,
    }
}

/// Whether two texts are one index in two spellings.
fn is_one_index(one: &str, other: &str) -> bool {
    reference(one).is_some_and(|index| Some(index) == reference(other))
}
