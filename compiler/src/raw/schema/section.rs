//! The sections of a description, in the order in which they are explained.

use schemars::{JsonSchema, SchemaGenerator};
use serde_json::{Map, Value, json};

use super::{text, texts};
use crate::model::*;
use crate::raw::{
    RawAxes, RawConfiguration, RawCoordinates, RawEntry, RawFacts, RawHead, RawMode, RawObject,
    RawObjectHead, RawPdo, RawProcedure, RawSyncManager, RawUnit, RawWord,
};

/// Gives the schemas of what the tables of a section can hold.
macro_rules! tables {
    ($($name:ident $field:ident $key:literal $shape:ident $table:ident,)*) => {
        /// All sections of a device: the key, how its tables are told apart, and the schema of one of them.
        static SECTIONS: &[(Section, fn(&mut SchemaGenerator) -> Value)] = &[
            $((Section::$name, |generator| table::<$table>(Section::$name, generator))),*
        ];
    };
}
for_each_section!(tables);

/// A section: its key, how its tables are told apart, and what makes the schema of one of them.
pub(super) type Described = (&'static str, Shape, fn(&mut SchemaGenerator) -> Value);

/// All sections, in the order in which they are explained.
pub(super) fn all() -> impl Iterator<Item = Described> {
    let lints: Described = ("lints", Shape::Single, |generator| together(vec![own::<Lints>(generator)]));
    SECTIONS.iter().map(|(section, table)| (section.name(), section.shape(), *table)).chain([lints])
}

/// The schema of a section with such tables.
pub(super) fn schema(shape: Shape, table: Value) -> Value {
    match shape {
        Shape::Single => table,
        Shape::Words | Shape::Numbers | Shape::Indices => {
            json!({ "type": "object", "additionalProperties": table })
        }
        Shape::List => json!({ "type": "array", "items": table }),
    }
}

/// The schema of a table of a section.
fn table<T: JsonSchema>(section: Section, generator: &mut SchemaGenerator) -> Value {
    let mut table = together(vec![own::<T>(generator), own::<RawFacts>(generator)]);
    if section == Section::Objects {
        let entry = together(vec![own::<RawEntry>(generator), own::<RawFacts>(generator)]);
        hold(&mut table, "entries", entry);
        let object = table.clone();
        hold(&mut table, "per-axis", object);
    }
    if !matches!(section.shape(), Shape::Single | Shape::List) {
        let like = text("Another table of the section, which this one is laid over.");
        begin(&mut table, [("like", like), ("without", texts("Paths of what it does not have of that."))]);
    }
    table
}

/// The keys of an object and those of its value.
impl JsonSchema for RawObject {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        "object".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> schemars::Schema {
        let mut object = together(vec![own::<RawObjectHead>(generator), own::<RawEntry>(generator)]);
        if let Some(keys) = object.get_mut("properties").and_then(Value::as_object_mut) {
            // what it is called comes first, what has tables of its own last
            for (key, place) in [("name", 1), ("entries", usize::MAX), ("per-axis", usize::MAX)] {
                if let Some(schema) = keys.shift_remove(key) {
                    keys.shift_insert(place.min(keys.len()), key.to_owned(), schema);
                }
            }
        }
        object.try_into().unwrap_or_default()
    }
}

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

/// The schema of a type, in place.
fn own<T: JsonSchema>(generator: &mut SchemaGenerator) -> Value {
    T::json_schema(generator).to_value()
}

/// Adds keys in front.
fn begin(table: &mut Value, first: [(&str, Value); 2]) {
    if let Some(keys) = table.get_mut("properties").and_then(Value::as_object_mut) {
        let others = std::mem::take(keys);
        keys.extend(first.map(|(key, schema)| (key.to_owned(), schema)));
        keys.extend(others);
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
