//! What lies in the EtherCAT slave controller and in its mailboxes.

use super::{Field, Source, model};
use crate::source::Origin;

model! {
    /// A register of the EtherCAT slave controller.
    pub struct Register {
        /// The address of its first byte.
        pub address: u16,
        /// Its length in bytes.
        pub length: u16,
        /// Its name.
        pub name: String,
        /// What the master may do with it.
        pub ecat: RegisterAccess,
        /// What the drive may do with it.
        pub drive: RegisterAccess,
        /// Its bits, lowest first.
        pub fields: Vec<Field>,
        /// What it is for.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }

    /// What one side may do with a register.
    #[derive(Copy, Eq)]
    #[cfg_attr(feature = "json", serde(rename_all = "snake_case"))]
    pub enum RegisterAccess {
        /// Nothing.
        None,
        /// Read it.
        R,
        /// Write it.
        W,
        /// Both.
        Rw,
    }

    /// Why the device refused or left an EtherCAT state.
    pub struct AlStatusCode {
        /// The code.
        pub code: u16,
        /// What it says.
        pub name: String,
        /// The changes of state that can end in it, or the states it is left from; any if empty.
        pub during: Vec<String>,
        /// The state that the device is in afterwards.
        pub results: Option<String>,
        /// What else is to be said.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
    }

    /// The bytes of a message.
    pub struct Telegram {
        /// The word for it.
        pub id: String,
        /// Its name.
        pub name: String,
        /// The address of its first byte in the EtherCAT slave controller.
        pub address: Option<u16>,
        /// What its bytes are; `low` and `high` count bytes.
        pub fields: Vec<Field>,
        /// What it is for.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }
}
