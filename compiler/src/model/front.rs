//! What a person sees and does.

use super::table::{part, table};
use super::{Address, Source, Value, model};
use crate::source::Origin;

table! {
    /// `[leds.<id>]`: a light.
    pub struct Led by id: "a word" {
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// What is printed beside it.
        pub name: String,
        /// Its colour.
        pub colour: Option<String>,
        /// What it shows.
        pub about: Option<String>,
        /// What its patterns mean.
        #[serde(default)]
        pub patterns: Vec<LedPattern>,
    }

    /// `[connectors.<id>]`: a socket.
    pub struct Connector by id: "a word" {
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// What is printed beside it.
        pub name: String,
        /// Its kind.
        pub kind: Option<String>,
        /// What goes in.
        pub about: Option<String>,
    }

    /// `[[master-settings]]`: something to be set in the master.
    pub struct MasterSetting {
        /// What.
        pub name: String,
        /// To which value.
        pub value: String,
        /// Whether once for each axis.
        #[serde(default)]
        pub per_axis: bool,
        /// Why.
        pub about: Option<String>,
    }

    /// `[limits.<id>]`: a figure that the device keeps to or asks for.
    pub struct Limit by id: "a word" {
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// What is limited.
        pub name: String,
        /// The figure with its unit.
        pub value: String,
        /// What happens beyond it.
        pub about: Option<String>,
    }
}

part! {
    /// What a light does, and what it means by that.
    pub struct LedPattern {
        /// What it does: `off`, `on`, `blinking`, `single flash` ...
        pub shows: String,
        /// What that means.
        pub means: String,
    }
}

model! {
    /// Things to do in order.
    pub struct Procedure by id {
        /// The word for it.
        pub id: String,
        /// What it achieves.
        pub name: String,
        /// What there is to know first.
        pub about: Option<String>,
        /// The steps.
        pub steps: Vec<Step>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(rename = "provenance"))]
        pub origin: Origin,
    }

    /// A step of a procedure.
    pub struct Step {
        /// What to do.
        pub text: String,
        /// The entry that it is done with.
        pub address: Option<Address>,
        /// The value to write.
        pub write: Option<Value>,
    }
}
