//! Time.

use super::table::{part, table};
use super::{Delay, Duration, ModeManagers};

table! {
    /// `[sync-modes.<id>]`: a way to keep time with the master.
    pub struct SyncMode by id: "a word" {
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// Its name.
        pub name: String,
        /// The value of the register that starts the distributed clocks; 0 for none.
        pub assign_activate: u16,
        /// Whether a master should take it if nothing is said.
        #[serde(default)]
        pub default: bool,
        /// The first signal.
        pub sync0: Option<SyncSignal>,
        /// The second signal.
        pub sync1: Option<SyncSignal>,
        /// What sync managers do in it other than by default, by their keys in `[sync-managers]`.
        #[serde(default)]
        pub managers: ModeManagers,
        /// What else is to be said.
        pub about: Option<String>,
    }

    /// `[cycle-times.<id>]`: how often set values may come.
    pub struct CycleTime by id: "a word" {
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// What the limit holds for.
        pub name: String,
        /// The shortest cycle.
        #[serde(rename(serialize = "min_ns"))]
        pub min: Option<Duration>,
        /// The cycles that can be chosen, if only some.
        #[serde(default, rename(serialize = "choices_ns"))]
        pub choices: Vec<Duration>,
        /// What else is to be said.
        pub about: Option<String>,
    }

    /// `[timeouts]`: how long a master waits for the device, for a change of the EtherCAT state and for mail.
    pub struct Timeouts {
        /// For Pre-Operational.
        #[serde(rename(serialize = "pre_op_ns"))]
        pub pre_op: Option<Duration>,
        /// For Safe-Operational and Operational.
        #[serde(rename(serialize = "safe_op_op_ns"))]
        pub safe_op_op: Option<Duration>,
        /// For Init, on the way back.
        #[serde(rename(serialize = "back_to_init_ns"))]
        pub back_to_init: Option<Duration>,
        /// For Safe-Operational, on the way back.
        #[serde(rename(serialize = "back_to_safe_op_ns"))]
        pub back_to_safe_op: Option<Duration>,
        /// Until the device has read a request.
        #[serde(rename(serialize = "request_ns"))]
        pub request: Option<Duration>,
        /// Until the device has answered it.
        #[serde(rename(serialize = "response_ns"))]
        pub response: Option<Duration>,
    }

    /// `[dead-time]`: the time from a set value to its effect.
    pub struct DeadTime {
        /// How many cycles of the master it takes.
        pub cycles: u32,
        /// How much time besides.
        #[serde(rename(serialize = "plus_ns"))]
        pub plus: Duration,
        /// How it comes about.
        pub about: Option<String>,
    }
}

part! {
    /// A signal of the distributed clocks.
    #[derive(Copy, Eq)]
    pub struct SyncSignal {
        /// Its period in cycles of the master, or how often it comes in one if negative: -4 is four times a cycle. 1 if
        /// absent.
        #[serde(default = "one")]
        pub cycles: i32,
        /// Its period, if that is a time of its own whatever the cycle of the master is.
        #[serde(rename(serialize = "period_ns"))]
        pub period: Option<Duration>,
        /// How much later than the cycle it comes; earlier if negative.
        #[serde(default, rename(serialize = "shift_ns"))]
        pub shift: Delay,
        /// How many cycles of the master it comes later besides.
        pub shift_cycles: Option<i32>,
        /// Whether it is counted from the inputs, not from the outputs.
        #[serde(default)]
        pub of_inputs: bool,
    }
}

fn one() -> i32 {
    1
}
