//! Time.

use super::{Source, model};
use crate::source::Origin;

model! {
    /// A way to keep time with the master.
    pub struct SyncMode {
        /// The word for it.
        pub id: String,
        /// Its name.
        pub name: String,
        /// The value of the register that starts the distributed clocks.
        pub assign_activate: u16,
        /// Whether a master should take it if nothing is said.
        pub default: bool,
        /// The first signal.
        pub sync0: Option<SyncSignal>,
        /// The second signal.
        pub sync1: Option<SyncSignal>,
        /// What else is to be said.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }

    /// A signal of the distributed clocks.
    pub struct SyncSignal {
        /// Its period in cycles of the master.
        pub cycles: i32,
        /// How much later than the cycle it comes, in nanoseconds.
        pub shift_ns: u64,
    }

    /// How often set values may come.
    pub struct CycleTime {
        /// The word for it.
        pub id: String,
        /// What the limit holds for.
        pub name: String,
        /// The shortest cycle in nanoseconds.
        pub min_ns: Option<u64>,
        /// The cycles that can be chosen in nanoseconds, if only some.
        pub choices_ns: Vec<u64>,
        /// What else is to be said.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
    }

    /// The time from a set value to its effect.
    pub struct DeadTime {
        /// How many cycles of the master it takes.
        pub cycles: u32,
        /// How much time besides, in nanoseconds.
        pub plus_ns: u64,
        /// How it comes about.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
    }
}
