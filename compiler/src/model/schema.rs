//! The schemas of values that TOML has no type of its own for: as they are written, and as the JSON model has them.

use std::borrow::Cow;

use schemars::generate::Contract;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde_json::json;

use super::{Delay, Duration, Fraction, Hex, Literal, OneOrMore, Place, Said};

/// Lets a text stand for the table, none of whose keys is needed in itself.
pub(crate) fn or_text(schema: &mut Schema) {
    schema.remove("required");
    let description = schema.remove("description");
    let table = std::mem::take(schema).to_value();
    schema.insert("anyOf".into(), json!([{ "type": "string" }, table]));
    if let Some(description) = description {
        schema.insert("description".into(), description);
    }
}

/// Gives a type the schema that it is written as, and that of the model if it has another there.
macro_rules! written {
    ($($type:ty as $name:literal: $written:tt $(in the model $model:ty)?;)+) => {
        $(
            impl JsonSchema for $type {
                fn inline_schema() -> bool {
                    true
                }

                fn schema_name() -> Cow<'static, str> {
                    $name.into()
                }

                fn json_schema(generator: &mut SchemaGenerator) -> Schema {
                    match generator.contract() {
                        $(Contract::Serialize => generator.subschema_for::<$model>(),)?
                        _ => json_schema!($written),
                    }
                }
            }
        )+
    };
}

written! {
    Literal as "value": { "type": ["boolean", "number", "string"] };
    Said as "said": { "type": ["boolean", "number", "string", "array", "object"] };
    Fraction as "fraction": { "type": ["integer", "string"], "pattern": "^ *[0-9]+ */ *[0-9]+ *$" };
    Duration as "time": { "type": "string", "pattern": "^[0-9]+ *(ns|us|µs|ms|s)$" } in the model u64;
    Delay as "delay": { "type": "string", "pattern": "^-?[0-9]+ *(ns|us|µs|ms|s)$" } in the model i64;
    Hex as "bytes": { "type": "string", "pattern": "^\\s*([0-9A-Fa-f]\\s*[0-9A-Fa-f]\\s*)*$" } in the model Vec<u8>;
    OneOrMore as "list": { "anyOf": [{ "type": "string" }, { "type": "array", "items": { "type": "string" } }] }
        in the model Vec<String>;
    Place as "place": { "type": "string" };
}
