//! The format as a JSON schema, for completion in an editor, and as a reference for people: both come from the
//! structs that descriptions are read into, and from their documentation.

mod literal;
mod reference;
mod section;
mod tidy;

use schemars::SchemaGenerator;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

pub use reference::reference;

use section::all;

/// The address by which the schema names itself.
const DIALECT: &str = "https://json-schema.org/draft/2020-12/schema";

/// The JSON schema of a file of a description.
///
/// Sections may lie in several files, and a profile, the family or another member may have stated what a table
/// leaves out: so no section and no key is demanded.
pub fn schema() -> String {
    let mut generator = generator();
    let mut tables: Map<String, Value> = all()
        .map(|(name, shape, table)| (name.into(), section::schema(shape, table(&mut generator))))
        .collect();
    let sections: Map<String, Value> = tables.keys().map(|name| (name.clone(), reference_to(name))).collect();
    tables.insert("members".into(), member(&sections));
    let keys = sections.into_iter().chain(file_keys());
    let keys: Map<String, Value> = keys.collect();
    tables.extend(generator.take_definitions(false));
    let mut root = json!({
        "$schema": DIALECT,
        "title": "devc description",
        "description": "A file of a device description.",
        "type": "object",
        "properties": keys,
        "$defs": tables,
    });
    tidy::tidy(&mut root);
    format!("{root:#}\n")
}

fn generator() -> SchemaGenerator {
    SchemaSettings::draft2020_12().for_deserialize().into_generator()
}

fn reference_to(definition: &str) -> Value {
    json!({ "$ref": format!("#/$defs/{definition}") })
}

/// The schema of a member: all sections, and two keys of its own.
fn member(sections: &Map<String, Value>) -> Value {
    let mut keys = Map::new();
    keys.insert("like".into(), text("Another member that this one is laid over."));
    keys.insert("without".into(), texts(WITHOUT));
    keys.extend(sections.clone());
    keys.shift_remove("lints");
    json!({
        "type": "object",
        "description": "What a member has of its own: any section, laid over that of the family.",
        "properties": keys,
    })
}

const WITHOUT: &str = "Paths of what is taken out, such as `objects.0x6098`.";

/// The keys that a file has besides the sections of a device.
fn file_keys() -> Map<String, Value> {
    let members = json!({
        "type": "object",
        "description": "The members of the family by name.",
        "additionalProperties": reference_to("members"),
    });
    let keys = [
        ("source", text("Where the facts of this file are from, unless a table says otherwise.")),
        (
            "profiles",
            texts("Profiles whose objects, words and states can be referred to: `ethercat`, `cia402`."),
        ),
        ("include", texts("Other files of the description, relative to this one.")),
        ("without", texts(WITHOUT)),
        ("members", members),
    ];
    keys.into_iter().map(|(key, schema)| (key.to_owned(), schema)).collect()
}

fn text(about: &str) -> Value {
    json!({ "type": "string", "description": about })
}

fn texts(about: &str) -> Value {
    json!({ "type": "array", "items": { "type": "string" }, "description": about })
}
