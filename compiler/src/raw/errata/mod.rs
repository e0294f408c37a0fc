//! Errata on the tree: what they quote is compared with what is written, and what holds is laid over it.
//!
//! Rules see the description as it is written. Outputs see the tree that is made here: what holds instead of what is
//! printed, and a mark at what is contradicted and nobody knows better.

mod amend;
mod apart;
mod locate;
mod quote;

use crate::diagnostic::{Diagnostic, Diagnostics, faults};
use crate::model::Erratum;
use crate::raw::RawDevice;
use crate::source::{Layer, Node, Table, Value};

use amend::amend;
use apart::apart;
use locate::Locate;

/// The tree as it holds; none if no erratum changes it or marks something in it.
///
/// A member of a family need not have what an erratum is about; what it lacks goes to `nowhere`.
pub(super) fn corrected(
    tree: &Table,
    device: &RawDevice,
    nowhere: &mut Vec<Diagnostic>,
    diagnostics: &mut Diagnostics,
) -> Option<Table> {
    let mut corrected = None;
    for (erratum, number) in device.errata.iter().zip(0_u16..) {
        let Some(says) = erratum.origin.node("says") else { continue };
        let holds = erratum.origin.node("holds");
        let Some(path) = Locate { tree, device }.path(&erratum.at) else {
            // What follows from other facts can be wrong, too, but is written nowhere.
            let quotes = says.table().is_none_or(|says| !says.members.is_empty());
            nowhere.extend((quotes || holds.is_some()).then(|| missing(erratum)));
            continue;
        };
        if let Some(fault) = quote::fault(tree, &path, erratum, says, holds) {
            diagnostics.push(fault);
            continue;
        }
        let tree = corrected.get_or_insert_with(|| tree.clone());
        let path = apart(tree, path, &erratum.at);
        match holds {
            Some(holds) => amend(tree, &path, says, Some(holds), Layer::Corrected(number)),
            None if erratum.stands => {}
            None => amend(tree, &path, says, None, Layer::Contradicted(number)),
        }
    }
    corrected
}

fn missing(erratum: &Erratum) -> Diagnostic {
    let message = format!("nothing is described at {}", erratum.at);
    let at = erratum.origin.value("at");
    Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, at, "not in this description")
}

/// A key or a place in a list on the way to a value.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Step {
    /// The key of a table.
    Key(String),
    /// The place in a list.
    Item(usize),
}

/// What stands at a path.
fn at<'t>(tree: &'t Table, path: &[Step]) -> Option<&'t Node> {
    let (first, rest) = path.split_first()?;
    let Step::Key(first) = first else { return None };
    let node = &tree.get(first)?.node;
    rest.iter().try_fold(node, |node, step| match (&node.value, step) {
        (Value::Table(table), Step::Key(key)) => table.get(key).map(|member| &member.node),
        (Value::Array(items), Step::Item(place)) => items.get(*place),
        _ => None,
    })
}
