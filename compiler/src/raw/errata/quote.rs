//! Whether an erratum quotes what is written.

use super::{Step, at};
use crate::diagnostic::{Diagnostic, faults};
use crate::model::Erratum;
use crate::source::{Member, Node, Table, Value};

/// What is wrong with what an erratum says and holds, if something is.
pub(super) fn fault(
    tree: &Table,
    path: &[Step],
    erratum: &Erratum,
    says: &Node,
    holds: Option<&Node>,
) -> Option<Diagnostic> {
    let written = at(tree, path)?;
    if let Some((quoted, found)) = misquoted(written, says) {
        let message = format!("the erratum does not quote what is written at {}", erratum.at);
        let fault = Diagnostic::new(&faults::MISQUOTED_ERRATUM, message, quoted.at, "quoted here");
        return Some(match found {
            Some(found) => fault.label(found.at, "written here"),
            None => fault.label(written.at, "nothing of it is written here"),
        });
    }
    let holds = holds?;
    let answer = |message: &str, label: &str| {
        Some(Diagnostic::new(&faults::MISQUOTED_ERRATUM, message.to_owned(), holds.at, label))
    };
    if erratum.stands {
        return answer("an erratum either stands or holds something else", "leave this out, or `stands`");
    }
    if same(says, holds) {
        let fault = answer("the erratum holds what it says", "the same");
        return fault.map(|fault| fault.help("write `stands = true` if the device is as the source says"));
    }
    None
}

/// The key for which a text alone can stand, of those that are quoted.
pub(super) fn word(says: &Table) -> Option<&Member> {
    ["name", "entry"].into_iter().find_map(|key| says.get(key))
}

/// What is quoted otherwise than it is written: the quoted value, and the written one if there is one.
fn misquoted<'n>(written: &'n Node, says: &'n Node) -> Option<(&'n Node, Option<&'n Node>)> {
    match (&says.value, &written.value) {
        _ if is_nothing(says) => None,
        (Value::Table(says), Value::Table(table)) => {
            says.members.iter().find_map(|member| match table.get(&member.key.name) {
                Some(written) => misquoted(&written.node, &member.node),
                None => Some((&member.node, None)),
            })
        }
        // A text may stand for a table of which it is the name or the entry.
        (Value::Table(says), Value::String(_)) => {
            let word = word(says);
            says.members
                .iter()
                .find(|member| Some(*member) != word || !same(&member.node, written))
                .map(|member| (&member.node, Some(written)))
        }
        _ => (!same(says, written)).then_some((says, Some(written))),
    }
}

/// Whether an erratum that says this quotes nothing.
pub(super) fn is_nothing(says: &Node) -> bool {
    says.table().is_some_and(|says| says.members.is_empty())
}

/// Whether two values are the same, wherever they stand.
pub(super) fn same(one: &Node, other: &Node) -> bool {
    match (&one.value, &other.value) {
        (Value::Table(one), Value::Table(other)) => {
            one.members.len() == other.members.len()
                && one.members.iter().all(|member| {
                    other.get(&member.key.name).is_some_and(|other| same(&member.node, &other.node))
                })
        }
        (Value::Array(one), Value::Array(other)) => {
            one.len() == other.len() && one.iter().zip(other.iter()).all(|(one, other)| same(one, other))
        }
        (one, other) => one == other,
    }
}
