//! What lies in the EtherCAT slave controller and in its mailboxes.

use super::Fields;
use super::table::{part, table};

table! {
    /// `[registers.<address>]`: a register of the EtherCAT slave controller.
    pub struct Register by address: "the address of a register such as 0x0120" {
        /// The address of its first byte.
        #[serde(skip_deserializing)]
        pub address: u16,
        /// Its length in bytes.
        pub length: u16,
        /// Its name.
        pub name: String,
        /// What the master may do with it.
        pub ecat: RegisterAccess,
        /// What the drive may do with it.
        pub drive: RegisterAccess,
        /// Its bits, counted from the first byte.
        #[serde(default, rename(serialize = "fields", deserialize = "bits"))]
        pub fields: Fields,
        /// What it is for.
        pub about: Option<String>,
    }

    /// `[al-status-codes.<code>]`: why the device refused or left an EtherCAT state.
    pub struct AlStatusCode by code: "an AL status code such as 0x0011" {
        /// The code.
        #[serde(skip_deserializing)]
        pub code: u16,
        /// What it says.
        pub name: String,
        /// The changes of state that can end in it, as `"PS"`, or the state that it is left from, as `"O"`; any
        /// if absent.
        #[serde(default)]
        pub during: Vec<String>,
        /// The state that the device is in afterwards.
        pub results: Option<String>,
        /// What else is to be said.
        pub about: Option<String>,
    }

    /// `[abort-codes.<code>]`: why the device ends an SDO transfer.
    pub struct AbortCode by code: "an SDO abort code such as 0x06010002" {
        /// The code.
        #[serde(skip_deserializing)]
        pub code: u32,
        /// What it says.
        pub name: String,
        /// What else is to be said.
        pub about: Option<String>,
    }

    /// `[telegrams.<id>]`: the bytes of a message.
    pub struct Telegram by id: "a word" {
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// Its name.
        pub name: String,
        /// The address of its first byte in the EtherCAT slave controller.
        pub address: Option<u16>,
        /// What its bytes are, by number, `"4"`, or by range, `"2..=3"`.
        #[serde(rename(serialize = "fields", deserialize = "bytes"))]
        pub fields: Fields,
        /// What it is for.
        pub about: Option<String>,
    }
}

part! {
    /// What one side may do with a register.
    #[derive(Copy, Eq, Default)]
    pub enum RegisterAccess {
        /// Nothing.
        #[default]
        None,
        /// Read it.
        R,
        /// Write it.
        W,
        /// Both.
        Rw,
    }
}
