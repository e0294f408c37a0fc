//! What lies in the EtherCAT slave controller and in its mailboxes: `[registers]`, `[al-status-codes]`,
//! `[telegrams]`.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::RawField;

/// `[registers.<address>]`: a register of the EtherCAT slave controller.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawRegister {
    /// Its name.
    pub name: String,
    /// Its length in bytes.
    pub length: u16,
    /// What the master may do with it.
    pub ecat: RawRegisterAccess,
    /// What the drive may do with it.
    pub drive: RawRegisterAccess,
    /// Its bits, counted from the first byte.
    #[serde(default)]
    pub bits: BTreeMap<String, RawField>,
    /// What it is for.
    pub about: Option<String>,
}

/// What one side may do with a register.
#[derive(Debug, Default, Clone, Copy, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum RawRegisterAccess {
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

/// `[al-status-codes.<code>]`: why the device refused or left an EtherCAT state.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawAlStatusCode {
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

/// `[telegrams.<id>]`: the bytes of a message.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawTelegram {
    /// Its name.
    pub name: String,
    /// The address of its first byte in the EtherCAT slave controller.
    pub address: Option<u16>,
    /// What its bytes are, by number, `"4"`, or by range, `"2..=3"`.
    pub bytes: BTreeMap<String, RawField>,
    /// What it is for.
    pub about: Option<String>,
}
