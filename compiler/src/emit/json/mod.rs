//! The JSON model: everything that is known of a family, for other people's tools.
//!
//! The output is the resolved model itself, word for word, under a name and a version of its own. Indices and
//! other numbers are numbers; a data type, a bit pattern and an enumeration are words. `model.schema.json`
//! describes every member.

#[cfg(feature = "schema")]
mod schema;

use serde::Serialize;

use super::{Emitter, Files, Options};
use crate::diagnostic::Rule;
use crate::lint::Checked;
use crate::model::Family;
use crate::text::characters::json;

#[cfg(feature = "schema")]
pub use schema::schema;

/// The word that tells this format from others.
pub const FORMAT: &str = "devc-model";

/// The version of the format: it grows when a reader of the version before could be misled.
pub const VERSION: u32 = 2;

/// The emitter of the JSON model.
#[derive(Debug)]
pub struct Json;

/// Devices as devc has resolved them from their description: every reference bound, every axis written out,
/// every PDO laid out. Indices are numbers; data types and bit patterns are words as descriptions write them.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(title = "devc model"))]
struct Document<'a> {
    /// Always `devc-model`.
    #[cfg_attr(feature = "schema", schemars(extend("const" = FORMAT)))]
    format: &'a str,
    /// The version of the format.
    #[cfg_attr(feature = "schema", schemars(extend("const" = VERSION)))]
    version: u32,
    /// The devices.
    #[serde(flatten)]
    family: &'a Family,
}

impl Emitter for Json {
    fn name(&self) -> &'static str {
        "json"
    }

    fn summary(&self) -> &'static str {
        "the complete model, for other tools"
    }

    fn ends(&self) -> &'static [&'static str] {
        &[".json"]
    }

    fn lints(&self) -> &'static [&'static Rule] {
        &[]
    }

    fn is_default(&self) -> bool {
        true
    }

    fn emit(&self, family: &Checked<Family>, _: &Options) -> Files {
        Files::one(format!("{}.json", family.id), document(family))
    }
}

fn document(family: &Family) -> String {
    let document = Document { format: FORMAT, version: VERSION, family };
    // Fails only for keys that are not text and for broken writers; the model has no maps, and a string takes all.
    json(&serde_json::to_string_pretty(&document).unwrap_or_default()).into_owned() + "\n"
}
