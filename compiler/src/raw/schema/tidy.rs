//! From what serde reads to what TOML can say.

use serde_json::{Value, json};

/// Takes out what TOML does not have: nothing as a value. Closes tables to keys that they do not know, and
/// demands none, as what a table leaves out can be in what it is laid over.
pub(super) fn tidy(schema: &mut Value) {
    let Value::Object(members) = schema else { return };
    members.remove("required");
    members.remove("default");
    if members.contains_key("properties") && !members.contains_key("additionalProperties") {
        members.insert("additionalProperties".into(), false.into());
    }
    without_null(schema);
    for (key, inner) in schema.as_object_mut().into_iter().flatten() {
        match (key.as_str(), inner) {
            ("properties" | "$defs", Value::Object(named)) => named.values_mut().for_each(tidy),
            ("anyOf" | "oneOf", Value::Array(choices)) => choices.iter_mut().for_each(tidy),
            ("items" | "additionalProperties", inner) => tidy(inner),
            _ => {}
        }
    }
}

/// Takes nothing out of the values that are allowed.
pub(super) fn without_null(schema: &mut Value) {
    if let Some(Value::Array(types)) = schema.get_mut("type") {
        types.retain(|name| name != "null");
        if let [only] = types.as_slice() {
            schema["type"] = only.clone();
        }
    }
    if let Some(Value::Array(choices)) = schema.get_mut("anyOf") {
        choices.retain(|choice| *choice != json!({ "type": "null" }));
        if let [Value::Object(only)] = choices.as_slice() {
            let only = only.clone();
            if let Some(members) = schema.as_object_mut() {
                members.remove("anyOf");
                members.extend(only);
            }
        }
    }
}
