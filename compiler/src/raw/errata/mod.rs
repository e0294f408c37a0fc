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

use amend::{Mark, amend};
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
        // What quotes nothing and holds nothing answers a finding, and leaves the mark to another erratum.
        if holds.is_none() && (erratum.stands || quote::is_nothing(says)) {
            continue;
        }
        let kind = if holds.is_some() { Layer::Corrected } else { Layer::Contradicted };
        let mut mark = Mark::of(kind(number));
        amend(tree, &path, says, holds, &mut mark);
        let other = mark.other.and_then(|other| device.errata.get(usize::from(other)));
        diagnostics.extend(other.map(|other| repeated(erratum, other)));
    }
    corrected
}

/// An erratum about a key of which another one says what holds already.
fn repeated(erratum: &Erratum, other: &Erratum) -> Diagnostic {
    let message = format!("two errata are about the same key at {}", erratum.at);
    let way = "put what holds, and how one knows, into one of them; if the other has to answer its rule, let it quote \
               nothing: `says = {}`";
    Diagnostic::new(&faults::MISQUOTED_ERRATUM, message, erratum.origin.value("says"), "quoted again")
        .label(other.origin.value("says"), "quoted here")
        .help(way)
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
