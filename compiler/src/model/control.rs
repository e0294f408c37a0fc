//! What the device does with what it is asked for at the wrong time.

use super::table::{part, table};

table! {
    /// `[device-control]`: what the device does with what it is asked for at the wrong time.
    pub struct DeviceControl {
        /// What it does with a command that leads nowhere in the present state, and with bits that make no command;
        /// it ignores them if absent.
        #[serde(default)]
        pub wrong_command: Refusal,
        /// What it does with a mode of operation that it does not have or does not change to; it ignores the change
        /// if absent.
        #[serde(default)]
        pub wrong_mode: Refusal,
        /// The states in which a mode of operation can be selected, by id; every one if absent.
        #[serde(default)]
        pub modes_selectable_in: Vec<String>,
        /// What else is to be said.
        pub about: Option<String>,
    }
}

part! {
    /// What the device does with what is not allowed.
    #[derive(Copy, Eq, Default)]
    pub enum Refusal {
        /// Nothing, as CiA 402 has it.
        #[default]
        Ignored,
        /// It takes it for a fault, and makes transition 13.
        Fault,
    }
}
