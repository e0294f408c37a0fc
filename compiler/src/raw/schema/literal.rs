//! The schemas of what the format has in every table.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};

use crate::raw::{Ignored, RawAssumed, RawSource};

/// Gives a type the schema that it is written as.
macro_rules! written {
    ($($type:ty as $name:literal: $schema:tt;)+) => {
        $(
            impl JsonSchema for $type {
                fn inline_schema() -> bool {
                    true
                }

                fn schema_name() -> Cow<'static, str> {
                    $name.into()
                }

                fn json_schema(_: &mut SchemaGenerator) -> Schema {
                    json_schema!($schema)
                }
            }
        )+
    };
}

written! {
    Ignored as "table": { "type": "object" };
    RawSource as "source": { "anyOf": [{ "type": "string" }, { "const": false }] };
    RawAssumed as "reasons": {
        "anyOf": [{ "type": "string" }, { "type": "object", "additionalProperties": { "type": "string" } }]
    };
}
