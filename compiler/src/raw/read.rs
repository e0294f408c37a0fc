//! From the tree to raw structs, each table on its own.

use std::sync::Arc;

use serde::de::DeserializeOwned;

use super::compose::{self, wrong_type};
use super::decode::Reader;
use super::{Entity, LintSetting, ObjectEntity, RawDevice, RawEntry, RawFacts, RawFamily, like};
use crate::diagnostic::{Diagnostic, Diagnostics, Level, faults};
use crate::source::{Document, Location, Member, Node, Origin, Table, Value};

/// Decodes a description: what its members share, and one [`RawDevice`] for each of them, or just one.
///
/// Every bad table is reported, not only the first; a member is left out if a table that all else needs is
/// missing.
pub fn read(
    document: &Document,
    id: &str,
    diagnostics: &mut Diagnostics,
) -> (Option<RawFamily>, Vec<RawDevice>) {
    let family = document.root.get("family").and_then(|member| {
        entity("family", member.key.at, &member.node, diagnostics).map(|family| family.raw)
    });
    let devices = members(document, id, diagnostics)
        .into_iter()
        .filter_map(|(id, tree, removed)| {
            let tree = compose::over_profile(&tree, &document.profile);
            device(id, &compose::strip(tree, &removed, diagnostics), diagnostics)
        })
        .collect();
    (family, devices)
}

/// The tree of each member with the lists of what is taken out of it: the shared one and its own.
fn members(document: &Document, id: &str, diagnostics: &mut Diagnostics) -> Vec<(String, Table, Vec<Node>)> {
    let mut shared = document.root.clone();
    shared.members.retain(|section| !matches!(&*section.key.name, "members" | "family"));
    // A table is like another as it is for all members.
    shared = like::alike(shared, diagnostics);
    let removed: Vec<Node> = shared.get("without").map(|list| list.node.clone()).into_iter().collect();
    let Some(members) = document.root.get("members") else {
        return vec![(id.to_owned(), shared, removed)];
    };
    let Some(members) = table_of(&members.node, diagnostics) else { return Vec::new() };
    let trees = members.members.iter().filter_map(|member| {
        let own = table_of(&member.node, diagnostics)?;
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

fn device(id: String, tree: &Table, diagnostics: &mut Diagnostics) -> Option<RawDevice> {
    let mut sections = Sections { tree, known: Vec::new(), diagnostics };
    let device = sections.device(id);
    sections.finish();
    device
}

/// The top level of the tree while it is being read.
struct Sections<'t> {
    tree: &'t Table,
    known: Vec<&'static str>,
    diagnostics: &'t mut Diagnostics,
}

impl Sections<'_> {
    fn device(&mut self, id: String) -> Option<RawDevice> {
        let head = self.required("device");
        let identity = self.required("identity");
        Some(RawDevice {
            id,
            eeprom: self.single("eeprom"),
            axes: self.single("axes"),
            mailbox: self.single("mailbox"),
            coordinates: self.single("coordinates"),
            dead_time: self.single("dead-time"),
            documents: self.map("documents"),
            areas: self.map("areas"),
            objects: self.objects(),
            rx_pdos: self.map("rx-pdos"),
            tx_pdos: self.map("tx-pdos"),
            sync_managers: self.map("sync-managers"),
            words: self.map("words"),
            states: self.map("states"),
            commands: self.map("commands"),
            transitions: self.map("transitions"),
            device_control: self.single("device-control"),
            communication_states: self.map("communication-states"),
            communication_transitions: self.map("communication-transitions"),
            modes: self.map("modes"),
            mode_changes: self.list("mode-changes"),
            stop_options: self.list("stop-options"),
            errors: self.map("errors"),
            vendor_codes: self.map("vendor-codes"),
            units: self.map("units"),
            sync_modes: self.map("sync-modes"),
            cycle_times: self.map("cycle-times"),
            leds: self.map("leds"),
            connectors: self.map("connectors"),
            parameters: self.map("parameters"),
            homing_methods: self.map("homing-methods"),
            registers: self.map("registers"),
            al_status_codes: self.map("al-status-codes"),
            telegrams: self.map("telegrams"),
            configurations: self.map("configurations"),
            limits: self.map("limits"),
            master_settings: self.list("master-settings"),
            procedures: self.map("procedures"),
            remarks: self.list("remarks"),
            errata: self.list("errata"),
            lints: self.lints(),
            head: head?,
            identity: identity?,
        })
    }

    fn take(&mut self, name: &'static str) -> Option<Member> {
        self.known.push(name);
        self.tree.get(name).cloned()
    }

    fn required<T: DeserializeOwned>(&mut self, name: &'static str) -> Option<Entity<T>> {
        if self.tree.get(name).is_none() {
            let message = format!("the description has no `[{name}]`");
            let missing = Diagnostic::new(&faults::MISSING_KEY, message, self.tree.at, "in this description");
            self.diagnostics.push(missing);
        }
        self.single(name)
    }

    fn single<T: DeserializeOwned>(&mut self, name: &'static str) -> Option<Entity<T>> {
        let member = self.take(name)?;
        entity(name, member.key.at, &member.node, self.diagnostics)
    }

    fn map<T: DeserializeOwned>(&mut self, name: &'static str) -> Vec<Entity<T>> {
        let Some(section) = self.take(name) else { return Vec::new() };
        self.members(&section)
            .iter()
            .filter_map(|m| entity(&m.key.name, m.key.at, &m.node, self.diagnostics))
            .collect()
    }

    fn list<T: DeserializeOwned>(&mut self, name: &'static str) -> Vec<Entity<T>> {
        let Some(section) = self.take(name) else { return Vec::new() };
        let Value::Array(items) = &section.node.value else {
            self.wrong(&section.node, "an array of tables");
            return Vec::new();
        };
        let entities = items.iter().enumerate();
        entities.filter_map(|(i, node)| entity(&i.to_string(), node.at, node, self.diagnostics)).collect()
    }

    fn objects(&mut self) -> Vec<ObjectEntity> {
        let Some(section) = self.take("objects") else { return Vec::new() };
        self.members(&section)
            .iter()
            .filter_map(|m| object(&m.key.name, m.key.at, &m.node, self.diagnostics))
            .collect()
    }

    fn lints(&mut self) -> Vec<LintSetting> {
        let Some(section) = self.take("lints") else { return Vec::new() };
        let mut settings = Vec::new();
        for member in self.members(&section) {
            let level = match &member.node.value {
                Value::String(level) => Level::parse(level),
                _ => None,
            };
            match level {
                Some(level) => {
                    let name = member.key.name.to_string();
                    settings.push(LintSetting { name, level, at: member.key.at });
                }
                None => self.wrong(&member.node, "`\"allow\"`, `\"warn\"` or `\"deny\"`"),
            }
        }
        settings
    }

    fn members(&mut self, section: &Member) -> Vec<Member> {
        match section.node.table() {
            Some(table) => table.members.clone(),
            None => {
                self.wrong(&section.node, "a table");
                Vec::new()
            }
        }
    }

    fn wrong(&mut self, node: &Node, expected: &str) {
        self.diagnostics.push(wrong_type(node, expected));
    }

    /// Reports sections that the format does not know.
    fn finish(mut self) {
        self.known.extend(["include", "profiles", "source", "without", "family", "members"]);
        for member in &self.tree.members {
            if !self.known.contains(&&*member.key.name) {
                self.diagnostics.push(super::decode::unknown_key(&member.key, &self.known));
            }
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

fn entity<T: DeserializeOwned>(
    key: &str,
    header: Location,
    node: &Node,
    diagnostics: &mut Diagnostics,
) -> Option<Entity<T>> {
    let table = table_of(node, diagnostics)?;
    let mut reader = Reader::new(&table, diagnostics);
    let raw = reader.part();
    let facts = reader.part::<RawFacts>();
    reader.finish();
    Some(Entity { key: key.to_owned(), origin: Origin::new(header, table), raw: raw?, facts: facts? })
}

fn object(key: &str, header: Location, node: &Node, diagnostics: &mut Diagnostics) -> Option<ObjectEntity> {
    let table = table_of(node, diagnostics)?;
    let mut reader = Reader::new(&table, diagnostics);
    let raw = reader.part();
    let value = reader.part::<RawEntry>();
    let facts = reader.part::<RawFacts>();
    reader.finish();
    let entries = inner(&table, "entries")
        .iter()
        .filter_map(|m| entity(&m.key.name, m.key.at, &m.node, diagnostics))
        .collect();
    let per_axis = per_axis(key, header, &table, diagnostics);
    let object = Entity { key: key.to_owned(), origin: Origin::new(header, table), raw: raw?, facts: facts? };
    Some(ObjectEntity { object, value: value?, entries, per_axis })
}

fn per_axis(
    key: &str,
    header: Location,
    table: &Table,
    diagnostics: &mut Diagnostics,
) -> Vec<(String, ObjectEntity)> {
    let mut shared = table.clone();
    shared.members.retain(|member| &*member.key.name != "per-axis");
    inner(table, "per-axis")
        .iter()
        .filter_map(|axes| {
            let overlay = table_of(&axes.node, diagnostics)?;
            let node = Node { at: axes.node.at, value: Value::Table(Arc::new(overlay.over(&shared))) };
            Some((axes.key.name.to_string(), object(key, header, &node, diagnostics)?))
        })
        .collect()
}

/// The members of a table inside a table.
fn inner<'t>(table: &'t Table, name: &str) -> &'t [Member] {
    table.get(name).and_then(|member| member.node.table()).map_or(&[], |table| &table.members)
}

#[cfg(all(test, feature = "schema"))]
mod tests {
    use super::*;
    use crate::raw::schema::sections;
    use crate::source::FileId;

    #[test]
    fn the_schema_has_the_sections_that_are_read() {
        let at = Location { file: FileId(0), start: 0, end: 0 };
        let tree = Table { at, members: Vec::new() };
        let mut sections_read =
            Sections { tree: &tree, known: Vec::new(), diagnostics: &mut Diagnostics::default() };
        sections_read.device(String::new());
        sections_read.known.sort_unstable();
        let mut described: Vec<&str> = sections().collect();
        described.sort_unstable();
        assert_eq!(sections_read.known, described);
    }
}
