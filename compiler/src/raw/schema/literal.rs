//! The schemas of values that TOML has no type of its own for.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};

use crate::raw::{Duration, Fraction, Hex, Ignored, Literal, OneOrMore, RawAssumed};

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
    Literal as "value": { "type": ["boolean", "number", "string"] };
    Fraction as "fraction": { "type": ["integer", "string"], "pattern": "^ *[0-9]+ */ *[0-9]+ *$" };
    Duration as "time": { "type": "string", "pattern": "^[0-9]+ *(ns|us|µs|ms|s)$" };
    Hex as "bytes": { "type": "string", "pattern": "^\\s*([0-9A-Fa-f]\\s*[0-9A-Fa-f]\\s*)*$" };
    OneOrMore as "list": { "anyOf": [{ "type": "string" }, { "type": "array", "items": { "type": "string" } }] };
    Ignored as "table": { "type": "object" };
    RawAssumed as "reasons": {
        "anyOf": [{ "type": "string" }, { "type": "object", "additionalProperties": { "type": "string" } }]
    };
}
