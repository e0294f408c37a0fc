//! What a person does: `[procedures]`.

use serde::Deserialize;

use super::raw;
use crate::model::Literal;

raw! {
    /// `[procedures.<id>]`: things to do in order.
    pub struct RawProcedure {
        /// What it achieves.
        pub name: String,
        /// What there is to know first.
        pub about: Option<String>,
        /// The steps.
        pub steps: Vec<RawStep>,
    }
}

/// A step of a procedure.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawStep {
    /// What to do.
    pub r#do: String,
    /// The object that it is done with.
    pub object: Option<String>,
    /// The value to write.
    pub write: Option<Literal>,
}
