//! The sections of a description, in the order in which they are explained.

use schemars::{JsonSchema, SchemaGenerator};
use serde_json::{Map, Value, json};

use super::{text, texts};
use crate::raw::*;

/// A section: a table at the top of a description.
pub(super) struct Section {
    /// Its key.
    pub(super) name: &'static str,
    /// How its tables are told apart.
    pub(super) shape: Shape,
    /// The schemas of what one of its tables can hold, all in the same table.
    parts: fn(&mut SchemaGenerator) -> Vec<Value>,
}

/// How the tables of a section are told apart.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Shape {
    /// There is one.
    Single,
    /// By key.
    Map,
    /// By place in a list.
    List,
}

/// Sections of a shape, each with what its tables hold.
macro_rules! section {
    ($name:literal, $shape:ident, $($part:ty),+) => {
        Section {
            name: $name,
            shape: Shape::$shape,
            parts: |generator| vec![$(own::<$part>(generator)),+],
        }
    };
}

/// All sections of a device.
pub(super) static SECTIONS: &[Section] = &[
    section!("device", Single, RawHead, RawFacts),
    section!("identity", Single, RawIdentity, RawFacts),
    section!("eeprom", Single, RawEeprom, RawFacts),
    section!("documents", Map, RawDocument, RawFacts),
    section!("axes", Single, RawAxes, RawFacts),
    section!("areas", Map, RawArea, RawFacts),
    section!("objects", Map, RawObject, RawEntry, RawFacts),
    section!("coordinates", Single, RawCoordinates, RawFacts),
    section!("parameters", Map, RawParameter, RawFacts),
    section!("units", Map, RawUnit, RawFacts),
    section!("rx-pdos", Map, RawPdo, RawFacts),
    section!("tx-pdos", Map, RawPdo, RawFacts),
    section!("sync-managers", Map, RawSyncManager, RawFacts),
    section!("mailbox", Single, RawMailbox, RawFacts),
    section!("configurations", Map, RawConfiguration, RawFacts),
    section!("words", Map, RawWord, RawFacts),
    section!("states", Map, RawState, RawFacts),
    section!("commands", Map, RawCommand, RawFacts),
    section!("transitions", Map, RawTransition, RawFacts),
    section!("device-control", Single, RawDeviceControl, RawFacts),
    section!("communication-states", Map, RawCommunicationState, RawFacts),
    section!("communication-transitions", Map, RawCommunicationTransition, RawFacts),
    section!("modes", Map, RawMode, RawFacts),
    section!("mode-changes", List, RawModeChange, RawFacts),
    section!("stop-options", List, RawStopOption, RawFacts),
    section!("homing-methods", Map, RawHomingMethod, RawFacts),
    section!("errors", Map, RawError, RawFacts),
    section!("vendor-codes", Map, RawVendorCode, RawFacts),
    section!("sync-modes", Map, RawSyncMode, RawFacts),
    section!("cycle-times", Map, RawCycleTime, RawFacts),
    section!("dead-time", Single, RawDeadTime, RawFacts),
    section!("registers", Map, RawRegister, RawFacts),
    section!("al-status-codes", Map, RawAlStatusCode, RawFacts),
    section!("telegrams", Map, RawTelegram, RawFacts),
    section!("leds", Map, RawLed, RawFacts),
    section!("connectors", Map, RawConnector, RawFacts),
    section!("limits", Map, RawLimit, RawFacts),
    section!("master-settings", List, RawMasterSetting, RawFacts),
    section!("procedures", Map, RawProcedure, RawFacts),
    section!("remarks", List, RawRemark, RawFacts),
    section!("errata", List, RawErratum, RawFacts),
    section!("lints", Single, Lints),
];

/// `[lints]`: levels by rule or by group: `"allow"`, `"warn"` or `"deny"`.
#[derive(JsonSchema)]
struct Lints {
    /// The level of each.
    #[expect(dead_code, reason = "only its schema is of use")]
    #[schemars(flatten)]
    levels: std::collections::BTreeMap<String, Level>,
}

/// How much a finding matters.
#[derive(JsonSchema)]
#[schemars(rename_all = "lowercase")]
#[expect(dead_code, reason = "only its schema is of use")]
enum Level {
    /// Not at all.
    Allow,
    /// It is reported.
    Warn,
    /// It is reported, and nothing is made of the description.
    Deny,
}

impl Section {
    /// What a family has besides its members.
    pub(super) const FAMILY: Self = section!("family", Single, RawFamily, RawFacts);

    /// The schema of the section.
    pub(super) fn schema(&self, generator: &mut SchemaGenerator) -> Value {
        let table = self.table(generator);
        match self.shape {
            Shape::Single => table,
            Shape::Map => json!({ "type": "object", "additionalProperties": table }),
            Shape::List => json!({ "type": "array", "items": table }),
        }
    }

    /// The schema of one of its tables.
    pub(super) fn table(&self, generator: &mut SchemaGenerator) -> Value {
        let mut table = together((self.parts)(generator));
        if self.name == "objects" {
            let entry = together(vec![own::<RawEntry>(generator), own::<RawFacts>(generator)]);
            hold(&mut table, "entries", entry);
            let object = table.clone();
            hold(&mut table, "per-axis", object);
        }
        if self.shape == Shape::Map {
            add(&mut table, "like", text("Another table of the section, which this one is laid over."));
            add(&mut table, "without", texts("Paths of what it does not have of that."));
        }
        table
    }
}

/// The schema of a type, in place.
fn own<T: JsonSchema>(generator: &mut SchemaGenerator) -> Value {
    T::json_schema(generator).to_value()
}

/// Adds a key.
fn add(table: &mut Value, key: &str, schema: Value) {
    if let Some(keys) = table.get_mut("properties").and_then(Value::as_object_mut) {
        keys.insert(key.into(), schema);
    }
}

/// Says what the tables within a key hold.
fn hold(table: &mut Value, key: &str, inner: Value) {
    let holder =
        table.get_mut("properties").and_then(|keys| keys.get_mut(key)).and_then(Value::as_object_mut);
    if let Some(holder) = holder {
        holder.insert("additionalProperties".into(), inner);
    }
}

/// The keys of all parts in one table, which is called after the first.
fn together(parts: Vec<Value>) -> Value {
    let mut table = Map::new();
    for (key, more) in parts.into_iter().filter_map(|part| part.as_object().cloned()).flatten() {
        match (table.get_mut(&key), more) {
            (Some(Value::Object(all)), Value::Object(more)) => all.extend(more),
            (Some(Value::Array(all)), Value::Array(more)) => all.extend(more),
            (None, more) => {
                table.insert(key, more);
            }
            _ => {}
        }
    }
    table.into()
}
