//! The tables of a description, each with the schema of its keys.

use std::fmt;

use serde_json::Value as Json;
use toml::{Table, Value};

/// A table of a description.
#[derive(Debug, Clone)]
pub(crate) struct Place {
    path: Vec<Step>,
    schema: Json,
}

#[derive(Debug, Clone, PartialEq)]
enum Step {
    Key(String),
    /// The key of a thing, as the file calls it.
    Thing(String),
    Item(usize),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let steps = self.path.iter().map(|step| match step {
            Step::Key(key) | Step::Thing(key) => key.clone(),
            Step::Item(place) => place.to_string(),
        });
        f.write_str(&steps.collect::<Vec<_>>().join("."))
    }
}

/// Every table that stands in a description, where the schema knows its keys.
pub(crate) fn places(base: &Table, schema: &Json) -> Vec<Place> {
    let mut found = Vec::new();
    let sections = schema["properties"].as_object().expect("sections");
    for (name, value) in base {
        let Some(section) = sections.get(name) else { continue };
        walk(value, section, vec![Step::Key(name.clone())], schema, &mut found);
    }
    found
}

fn walk(value: &Value, holds: &Json, path: Vec<Step>, schema: &Json, found: &mut Vec<Place>) {
    let further = |step: Step| [path.clone(), vec![step]].concat();
    match value {
        Value::Table(table) => {
            let holds = table_of(holds, schema);
            if holds.get("properties").is_some() {
                found.push(Place { path: path.clone(), schema: holds.clone() });
            }
            for (key, value) in table {
                let (inner, step) = match holds["properties"].get(key) {
                    Some(inner) => (Some(inner), Step::Key(key.clone())),
                    None => (holds.get("additionalProperties"), Step::Thing(key.clone())),
                };
                if let Some(inner) = inner.filter(|inner| inner.is_object()) {
                    walk(value, inner, further(step), schema, found);
                }
            }
        }
        Value::Array(items) => {
            let inner = resolved(holds, schema)["items"].clone();
            for (place, item) in items.iter().enumerate() {
                walk(item, &inner, further(Step::Item(place)), schema, found);
            }
        }
        _ => {}
    }
}

/// The schema behind references.
pub(crate) fn resolved(holds: &Json, schema: &Json) -> Json {
    match holds.get("$ref").and_then(Json::as_str) {
        Some(reference) => {
            let pointer = reference.trim_start_matches('#');
            let named = schema.pointer(pointer).unwrap_or_else(|| panic!("{reference} is in the schema"));
            resolved(named, schema)
        }
        None => holds.clone(),
    }
}

/// The schema of a table, which a text may stand for.
fn table_of(holds: &Json, schema: &Json) -> Json {
    let holds = resolved(holds, schema);
    let choices = holds.get("anyOf").and_then(Json::as_array).cloned();
    let mut choices = choices.into_iter().flatten().map(|choice| resolved(&choice, schema));
    choices.find(|choice| choice.get("properties").is_some()).unwrap_or(holds)
}

impl Place {
    /// The path, with a star for what the file has names for.
    pub(crate) fn kind(&self) -> String {
        let steps = self.path.iter().map(|step| match step {
            Step::Key(key) => key.as_str(),
            Step::Thing(_) | Step::Item(_) => "*",
        });
        steps.collect::<Vec<_>>().join(".")
    }

    /// The keys that the table can have, with what each holds. Tables in it have places of their own.
    pub(crate) fn keys(&self, schema: &Json) -> Vec<(String, Json)> {
        let keys = self.schema["properties"].as_object().cloned().unwrap_or_default();
        let keys = keys.into_iter().map(|(key, holds)| (key, resolved(&holds, schema)));
        // They lay tables over each other before anything is read, and have tests of their own.
        keys.filter(|(key, _)| !matches!(key.as_str(), "like" | "without")).collect()
    }

    /// The table in a description.
    pub(crate) fn table<'b>(&self, base: &'b Table) -> Option<&'b Table> {
        let (first, rest) = self.path.split_first()?;
        let first = match first {
            Step::Key(key) | Step::Thing(key) => base.get(key)?,
            Step::Item(_) => return None,
        };
        let found = rest.iter().try_fold(first, |table, step| match step {
            Step::Key(key) | Step::Thing(key) => table.get(key),
            Step::Item(place) => table.get(*place),
        });
        found?.as_table()
    }

    /// The description without a key of the table.
    pub(crate) fn without(&self, base: &Table, key: &str) -> Option<Table> {
        let mut changed = base.clone();
        self.table_mut(&mut changed)?.remove(key)?;
        Some(changed)
    }

    /// Whether the table can say why its facts are assumed.
    pub(crate) fn can_assume(&self) -> bool {
        self.schema["properties"].get("assumed").is_some()
    }

    /// The keys that a description states in the table.
    pub(crate) fn stated(&self, base: &Table) -> Vec<String> {
        let keys = self.table(base).into_iter().flat_map(Table::keys);
        keys.filter(|key| !matches!(key.as_str(), "like" | "without")).cloned().collect()
    }

    /// The description with a key of the table set to something else; none if that is what it says already.
    pub(crate) fn with(&self, base: &Table, key: &str, value: Value) -> Option<Table> {
        let mut changed = base.clone();
        let old = self.table_mut(&mut changed)?.insert(key.to_owned(), value.clone());
        (old.as_ref() != Some(&value)).then_some(changed)
    }

    fn table_mut<'b>(&self, base: &'b mut Table) -> Option<&'b mut Table> {
        let (first, rest) = self.path.split_first()?;
        let mut table = match first {
            Step::Key(key) | Step::Thing(key) => base.get_mut(key)?,
            Step::Item(_) => return None,
        };
        for step in rest {
            table = match step {
                Step::Key(key) | Step::Thing(key) => table.get_mut(key)?,
                Step::Item(place) => table.get_mut(*place)?,
            };
        }
        table.as_table_mut()
    }
}
