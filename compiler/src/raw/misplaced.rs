//! Keys that belong above the first table and stand below one, where TOML makes them keys of that table.

use crate::diagnostic::{Diagnostic, faults};
use crate::source::{Table, Value};

/// What only the top of a file has: lists of profiles and of other files.
const ABOVE: [&str; 2] = ["profiles", "include"];

/// The keys that are misplaced. What they would have brought in is missing, so that nothing else is worth a message.
pub(super) fn misplaced(root: &Table) -> Vec<Diagnostic> {
    let tables = root.members.iter().filter_map(|member| Some((member, member.node.table()?)));
    tables.flat_map(|(member, table)| within(&member.key.name, table)).collect()
}

fn within(path: &str, table: &Table) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for member in &table.members {
        let name = &*member.key.name;
        match &member.node.value {
            Value::Array(_) if ABOVE.contains(&name) => {
                let message = format!("`{name}` stands in `[{path}]`, but belongs to the whole file");
                let fault =
                    Diagnostic::new(&faults::UNKNOWN_KEY, message, member.key.at, "not a key of this table");
                found.push(fault.help("write it above the first line in brackets"));
            }
            Value::Table(inner) => found.extend(within(&format!("{path}.{name}"), inner)),
            _ => {}
        }
    }
    found
}
