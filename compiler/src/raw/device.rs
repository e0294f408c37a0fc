//! What the device is: `[device]`, `[identity]`, `[documents]`, `[members]`.

use serde::Deserialize;

use super::Hex;

/// `[device]`: how the drive is named and grouped.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawHead {
    /// The name people order it by.
    pub name: String,
    /// The vendor's name.
    pub vendor: String,
    /// What it is, in one line.
    pub title: Option<String>,
    /// What it is, in a paragraph.
    pub about: Option<String>,
    /// The order numbers that share this description.
    #[serde(default)]
    pub models: Vec<String>,
    /// The group a configuration tool lists it under; the vendor's name for its drives.
    pub group: Option<String>,
    /// The type as an ESI names it, without spaces; made from the name if absent.
    pub type_name: Option<String>,
    /// The device profile it follows, 402 for drives.
    pub profile: Option<u32>,
    /// One letter for each port as ESI wants it: `Y` for MII (RJ45), `K` for LVDS (E-Bus).
    pub physics: Option<String>,
}

/// `[family]`: what the members of a family have in common.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawFamily {
    /// The name of the family.
    pub name: String,
    /// What its members share, and what tells them apart.
    pub about: Option<String>,
}

/// `[identity]`: what the identity object 0x1018 and the EEPROM say.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawIdentity {
    /// The vendor id that the ETG assigned.
    pub vendor_id: u32,
    /// The product code.
    pub product_code: u32,
    /// The revision number.
    pub revision: u32,
    /// The serial number of a device that has none of its own.
    pub serial: Option<u32>,
}

/// `[documents.<id>]`: a document that facts are taken from.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawDocument {
    /// Its title.
    pub title: String,
    /// Its number.
    pub number: Option<String>,
    /// Its edition or date.
    pub edition: Option<String>,
    /// Who published it.
    pub publisher: Option<String>,
    /// What it is good for.
    pub about: Option<String>,
}

/// `[eeprom]`: the SII EEPROM.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawEeprom {
    /// Its size in bytes.
    pub size: Option<u32>,
    /// The first bytes of it, PDI control and what follows, in hexadecimal.
    pub config_data: Option<Hex>,
}

/// `[axes]`: the axes of a device and how their objects are spaced.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawAxes {
    /// The names, in order.
    pub names: Vec<String>,
    /// What each axis does, in the order of the names.
    #[serde(default)]
    pub about: Vec<String>,
    /// Which objects exist once for each axis, and how far apart they are.
    #[serde(default)]
    pub shifts: Vec<RawShift>,
    /// How far apart the PDOs of the axes are.
    pub pdo_shift: Option<u16>,
    /// How the axes depend on each other.
    pub coupling: Option<String>,
}

/// A range of indices that exists once for each axis.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub struct RawShift {
    /// The indices of the first axis, as `"0x6000..=0x67FF"`.
    pub range: String,
    /// The distance from an axis to the next.
    pub by: u16,
}
