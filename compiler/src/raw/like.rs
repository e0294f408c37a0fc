//! Tables that are like another one of their section.

use std::sync::Arc;

use super::compose::{strip, wrong_type};
use crate::diagnostic::{Diagnostic, Diagnostics, faults};
use crate::source::{Node, Table, Value};
use crate::text::near::{list, near};

/// Lays each table with the key `like` over the one of its section that it names, but for the `id` of that and what
/// `without` takes out.
pub(super) fn alike(mut root: Table, diagnostics: &mut Diagnostics) -> Table {
    for member in &mut root.members {
        if let Value::Table(section) = &mut member.node.value
            && section.members.iter().any(|entity| says_like(&entity.node))
        {
            *section = Arc::new(completed(section, diagnostics));
        }
    }
    root
}

fn says_like(node: &Node) -> bool {
    node.table().is_some_and(|table| table.get("like").is_some())
}

/// The section with its tables laid over what they are like.
fn completed(section: &Table, diagnostics: &mut Diagnostics) -> Table {
    let mut whole = section.clone();
    for entity in whole.members.iter_mut().filter(|entity| says_like(&entity.node)) {
        let Value::Table(own) = &mut entity.node.value else { continue };
        let base = find(own, section, diagnostics);
        let mut own_keys = Table::clone(own);
        own_keys.members.retain(|member| !matches!(&*member.key.name, "like" | "without"));
        let laid = base.map(|base| {
            let mut base = Table::clone(&base);
            base.members.retain(|member| &*member.key.name != "id");
            let removed = own.get("without").map(|list| list.node.clone());
            own_keys.over(&strip(base, removed.as_slice(), diagnostics))
        });
        *own = Arc::new(laid.unwrap_or(own_keys));
    }
    whole
}

/// The table that this one is like; that must stand for itself.
pub(super) fn find(own: &Table, section: &Table, diagnostics: &mut Diagnostics) -> Option<Arc<Table>> {
    let named = &own.get("like")?.node;
    let Value::String(name) = &named.value else {
        diagnostics.push(wrong_type(named, "the key of a table in the same section"));
        return None;
    };
    let found = section.get(name).and_then(|other| other.node.table());
    let fault = match found {
        Some(other) if other.get("like").is_none() => return Some(other.clone()),
        Some(_) => {
            let message = format!("`{name}` is itself like another");
            let label = "name the one that stands for itself";
            Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, named.at, label)
        }
        None => missing(name, named, section, diagnostics.has_room(&faults::UNKNOWN_REFERENCE)),
    };
    diagnostics.push(fault);
    None
}

fn missing(name: &str, named: &Node, section: &Table, explained: bool) -> Diagnostic {
    let message = format!("there is no `{name}` to be like");
    let fault =
        Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, named.at, "no such table in the section");
    if !explained {
        return fault;
    }
    let known: Vec<&str> = section.members.iter().map(|member| &*member.key.name).collect();
    match near(name, known.iter().copied()) {
        Some(near) => fault.fix(format!("there is `{near}`"), named.at, format!("\"{near}\"")),
        None => fault.note(format!("there are {}", list(&known))),
    }
}
