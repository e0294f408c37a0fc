//! The schema of the JSON model.

use schemars::generate::SchemaSettings;

use super::Document;

/// The JSON schema of the output, documented by the documentation of the model.
pub fn schema() -> String {
    let settings = SchemaSettings::draft2020_12().for_serialize();
    let schema = settings.into_generator().into_root_schema_for::<Document<'_>>();
    format!("{:#}\n", schema.as_value())
}
