//! Homing methods.

use super::{Source, model};
use crate::source::Origin;

model! {
    /// A way to find the reference position.
    pub struct HomingMethod {
        /// Its number in 0x6098.
        pub number: i8,
        /// Other numbers that select it.
        pub aliases: Vec<i8>,
        /// The word for it.
        pub id: String,
        /// Its name.
        pub name: String,
        /// The vendor's own name for it.
        pub method: Option<String>,
        /// The direction in which it starts; none if it does not move.
        pub direction: Option<Way>,
        /// Whether it ends on an index pulse.
        pub pulse: bool,
        /// What it looks for besides.
        pub target: Option<String>,
        /// The parameters that it uses.
        pub parameters: Vec<String>,
        /// What the drive does, step by step.
        pub steps: Vec<String>,
        /// What it does instead where that depends on where it starts.
        pub alternatives: Vec<Alternative>,
        /// What else is to be said.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }

    /// A direction of movement.
    #[derive(Copy, Eq)]
    #[cfg_attr(feature = "json", serde(rename_all = "snake_case"))]
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
