//! What can go wrong in the drive: `[errors]`, `[vendor-codes]`.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::RawField;

/// `[errors.<code>]` or `[errors."<code>..=<code>"]`: an error code of object 0x603F.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawError {
    /// Its name.
    pub name: String,
    /// The error register that comes with it.
    pub register: Option<u8>,
    /// The vendor's own codes for it.
    #[serde(default)]
    pub vendor_codes: Vec<u32>,
    /// What it means.
    pub about: Option<String>,
    /// What to do about it.
    pub remedy: Option<String>,
}

/// `[vendor-codes.<code>]`: a code of the vendor's own system.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawVendorCode {
    /// Its name.
    pub name: String,
    /// What it means.
    pub about: Option<String>,
    /// What can have caused it, by the number that the device gives the cause.
    #[serde(default)]
    pub causes: BTreeMap<String, RawField>,
}
