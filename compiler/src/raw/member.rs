//! The members of a family: what they share, and what each has of its own.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::compose::{self, wrong_type};
use super::extent::Room;
use super::read::Sections;
use super::{RawDevice, errata, like, misplaced};
use crate::diagnostic::{Diagnostic, Diagnostics, faults};
use crate::model::Index;
use crate::source::{Document, Key, Node, Sources, Table, Value, keys};
use crate::text::files;

/// A device as it is written, and as it holds.
#[derive(Debug)]
pub struct Reading {
    /// As it is written: what rules judge.
    pub printed: RawDevice,
    /// With what errata say instead, if they say something: what outputs show.
    pub corrected: Option<RawDevice>,
}

/// Decodes a description: each member of its family, or the one device.
///
/// Every bad table is reported, not only the first.
pub fn read(document: &Document, id: &str, sources: &Sources, diagnostics: &mut Diagnostics) -> Vec<Reading> {
    let misplaced = misplaced::misplaced(&document.root);
    if !misplaced.is_empty() {
        diagnostics.extend(misplaced);
        return Vec::new();
    }
    let trees = members(document, id, diagnostics);
    let (mut nowhere, mut room) = (Vec::new(), Room::new());
    let offered = Arc::new(offered(&document.profile));
    let devices: Vec<Reading> = trees
        .into_iter()
        .map_while(|(id, tree, removed)| {
            let tree = compose::over_profile(&tree, &document.profile);
            let tree = compose::strip(tree, &removed, diagnostics);
            if !room.take_device(&tree, diagnostics) {
                return None;
            }
            let printed = Sections::new(&tree, sources, diagnostics).device(id.clone(), offered.clone());
            let held = match diagnostics.has_errors() {
                true => None,
                false => errata::corrected(&tree, &printed, &mut nowhere, diagnostics),
            };
            let corrected =
                held.map(|tree| Sections::new(&tree, sources, diagnostics).device(id, offered.clone()));
            Some(Reading { printed, corrected })
        })
        .collect();
    let everywhere = |fault: &&Diagnostic| {
        let has = |reading: &&Reading| {
            reading.printed.errata.iter().any(|it| fault.at() == Some(it.origin.value("at")))
        };
        nowhere.iter().filter(|other| other == fault).count() == devices.iter().filter(has).count()
    };
    diagnostics.extend(nowhere.iter().filter(everywhere).cloned());
    devices
}

/// The objects that a profile has, by id.
fn offered(profile: &Table) -> BTreeMap<String, Index> {
    let objects = profile.get("objects").and_then(|objects| objects.node.table());
    let objects = objects.iter().flat_map(|objects| &objects.members);
    let named = objects.filter_map(|object| {
        let id = object.node.table()?.get("id")?;
        let Value::String(id) = &id.node.value else { return None };
        let index = keys::number(&object.key.name).and_then(|index| u16::try_from(index).ok())?;
        Some((id.to_string(), Index(index)))
    });
    named.collect()
}

/// The tree of each member with the lists of what is taken out of it: the shared one and its own.
fn members(document: &Document, id: &str, diagnostics: &mut Diagnostics) -> Vec<(String, Table, Vec<Node>)> {
    let mut shared = document.root.clone();
    shared.members.retain(|section| &*section.key.name != "members");
    // A table is like another as it is for all members.
    shared = like::alike(shared, diagnostics);
    let removed: Vec<Node> = shared.get("without").map(|list| list.node.clone()).into_iter().collect();
    let Some(members) = document.root.get("members") else {
        return vec![(id.to_owned(), shared, removed)];
    };
    let at = members.key.at;
    let Some(members) = table_of(&members.node, diagnostics) else { return Vec::new() };
    if !Room::new().take(&shared, members.members.len(), at, diagnostics) {
        return Vec::new();
    }
    names(&members, diagnostics);
    let trees = members.members.iter().filter_map(|member| {
        let own = table_of(&member.node, diagnostics)?;
        diagnostics.extend(own.get("lints").map(|lints| shared_only(&lints.key)));
        let like = like::find(&own, &members, diagnostics);
        let lists = [like.as_deref(), Some(&*own)].into_iter().flatten().filter_map(|t| t.get("without"));
        let removed = removed.iter().cloned().chain(lists.map(|list| list.node.clone())).collect();
        let mut tree = like.iter().fold(shared.clone(), |tree, like| like.over(&tree));
        tree = like::alike(own.over(&tree), diagnostics);
        tree.members.retain(|section| &*section.key.name != "like");
        Some((member.key.name.to_string(), tree, removed))
    });
    trees.collect()
}

/// Some outputs are a file of each member, which has its name.
fn names(members: &Table, diagnostics: &mut Diagnostics) {
    let mut known: BTreeMap<String, &Key> = BTreeMap::new();
    for member in &members.members {
        let key = &member.key;
        if let Some(fault) = files::fault(&key.name) {
            let message = format!("{:?} cannot be the name of a member: {fault}", key.name);
            let fault = Diagnostic::new(&faults::INVALID_VALUE, message, key.at, "no name of a file");
            diagnostics.push(fault.note("outputs that are a file of each member take their names from it"));
        } else if let Some(other) = known.insert(key.name.to_lowercase(), key) {
            let message = format!("`{}` and `{}` differ in case only", other.name, key.name);
            let fault = Diagnostic::new(&faults::INVALID_VALUE, message, key.at, "one name on some systems");
            let fault = fault.label(other.at, "the other member");
            diagnostics.push(fault.note("outputs that are a file of each member take their names from it"));
        }
    }
}

fn table_of(node: &Node, diagnostics: &mut Diagnostics) -> Option<Arc<Table>> {
    let table = node.table().cloned();
    if table.is_none() {
        diagnostics.push(wrong_type(node, "a table"));
    }
    table
}

/// That a section cannot differ for a member.
fn shared_only(key: &Key) -> Diagnostic {
    let message = format!("`{}` is the same for all members", key.name);
    Diagnostic::new(&faults::UNKNOWN_KEY, message, key.at, "not a key of a member")
        .help(format!("write `[{}]` at the top of the description", key.name))
}
