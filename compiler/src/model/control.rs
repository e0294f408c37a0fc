//! What the device does with what it is asked for at the wrong time.

use super::{Source, model};

model! {
    /// What the device does with what it is asked for at the wrong time.
    pub struct DeviceControl {
        /// What it does with a command that leads nowhere in the present state, and with bits that make none.
        pub wrong_command: Refusal,
        /// What it does with a mode of operation that it does not have or does not change to.
        pub wrong_mode: Refusal,
        /// The states in which a mode of operation can be selected, by id; every one if empty.
        pub modes_selectable_in: Vec<String>,
        /// What else is to be said.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
    }

    /// What the device does with what is not allowed.
    #[derive(Copy, Eq)]
    #[cfg_attr(feature = "json", serde(rename_all = "snake_case"))]
    pub enum Refusal {
        /// Nothing.
        Ignored,
        /// It takes it for a fault, and makes transition 13.
        Fault,
    }
}
