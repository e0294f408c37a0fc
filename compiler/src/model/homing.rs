//! Homing methods.

use super::table::{part, table};

table! {
    /// `[homing-methods.<number>]`: a way to find the reference position, by its number in 0x6098.
    pub struct HomingMethod by number: "the number of a homing method, -128 to 127" {
        /// Its number in 0x6098.
        #[serde(skip_deserializing)]
        pub number: i8,
        /// Other numbers that select it.
        #[serde(default)]
        pub aliases: Vec<i8>,
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// Its name.
        pub name: String,
        /// The vendor's own name for it.
        pub method: Option<String>,
        /// The direction in which it starts; none if it does not move.
        pub direction: Option<Way>,
        /// Whether it ends on an index pulse.
        #[serde(default)]
        pub pulse: bool,
        /// What it looks for besides.
        pub target: Option<String>,
        /// The parameters that it uses.
        #[serde(default)]
        pub parameters: Vec<String>,
        /// What the drive does, step by step.
        #[serde(default)]
        pub steps: Vec<String>,
        /// What it does instead where that depends on where it starts.
        #[serde(default)]
        pub alternatives: Vec<Alternative>,
        /// What else is to be said.
        pub about: Option<String>,
    }
}

part! {
    /// A direction of movement.
    #[derive(Copy, Eq)]
    pub enum Way {
        /// Towards greater positions.
        Positive,
        /// Towards smaller positions.
        Negative,
    }

    /// What happens in one of several cases.
    pub struct Alternative {
        /// The case.
        pub when: String,
        /// What the drive does, step by step.
        pub steps: Vec<String>,
    }
}
