//! Process data and what carries it: `[rx-pdos]`, `[tx-pdos]`, `[sync-managers]`.

use serde::Deserialize;
use serde::de::Deserializer;

use super::raw;
use crate::model::shorthand::shorthand;
use crate::model::{Oversampling, Translations};

raw! {
    /// `[rx-pdos.<index>]`, `[tx-pdos.<index>]`: a process data object.
    pub struct RawPdo called index {
        /// Its name.
        pub name: String,
        /// Its name in other languages, by language: `{ de = "..." }`.
        #[serde(default)]
        pub names: Translations,
        /// Whether each axis has one, `pdo-shift` apart; the table describes the first axis' one.
        #[serde(default)]
        pub per_axis: bool,
        /// What is in it, in order.
        #[serde(default)]
        pub entries: Vec<RawMapped>,
        /// Whether its mapping cannot be changed; true if absent.
        pub fixed: Option<bool>,
        /// Whether it cannot be taken out of its sync manager.
        #[serde(default)]
        pub mandatory: bool,
        /// The PDOs that cannot be assigned together with it.
        #[serde(default)]
        pub excludes: Vec<String>,
        /// The mode of operation it is meant for.
        pub mode: Option<i16>,
        /// The number of bytes that the manual gives for it.
        pub total: Option<u16>,
        /// The largest number of bytes it can be mapped to, for a free mapping.
        pub max_bytes: Option<u16>,
        /// The largest number of entries it can be mapped to: the subindices of its mapping object. If absent, those that
        /// it has, or with a free mapping everything that can be mapped once, as far as `max-bytes` go.
        pub max_entries: Option<u8>,
        /// The sync unit it belongs to: PDOs of different ones are exchanged apart from each other.
        pub sync_unit: Option<String>,
        /// Whether it is there for a master's own programs only, and the device knows nothing of it.
        #[serde(default)]
        pub r#virtual: bool,
        /// How often its values can be there in a cycle, if they can be several times: `{ factor = 10, min = 1, max = 100,
        /// step = 8 }`, with the step of the indices of what is there several times.
        pub oversampling: Option<Oversampling>,
        /// What it is for.
        pub about: Option<String>,
    }
}

/// An entry of a PDO: a reference such as `"controlword"` or `"0x6040:00"`, or a table.
#[derive(Debug, Clone, Default)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(transform = crate::model::schema::or_text))]
pub struct RawMapped {
    /// The object or entry, or a range of entries such as `"0x2003:01..=08"`; none for padding.
    pub entry: Option<String>,
    /// The width that the manual gives, needed for padding and for what is not in the dictionary, unless it has a `type`.
    pub bits: Option<u16>,
    /// The data type of what is not in the dictionary; of what is there one of the same width, which masters are told in
    /// its place.
    pub r#type: Option<String>,
    /// A name other than the entry's.
    pub name: Option<String>,
    /// The name in other languages, by language, where it is not the entry's.
    pub names: Translations,
    /// What it is for in this PDO.
    pub about: Option<String>,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
struct MappedTable {
    entry: Option<String>,
    bits: Option<u16>,
    r#type: Option<String>,
    name: Option<String>,
    #[serde(default)]
    names: Translations,
    about: Option<String>,
}

impl<'de> Deserialize<'de> for RawMapped {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let expecting = "the name or index of an entry, or a table with `entry`, `bits`, `type`, `name`, `names` and `about`";
        let MappedTable { entry, bits, r#type, name, names, about } =
            shorthand(deserializer, "entry", expecting)?;
        Ok(Self { entry, bits, r#type, name, names, about })
    }
}

raw! {
    /// `[sync-managers.<role>]`: a memory area of the EtherCAT slave controller. The roles are `mailbox-out`,
    /// `mailbox-in`, `outputs` and `inputs`; where there are several of a role, the key is any word and `role` says it.
    pub struct RawSyncManager {
        /// What it is for, if its key does not say it.
        pub role: Option<String>,
        /// Its number, which is its place among the sync managers; if absent, they lie in the order of the roles, and
        /// those of one role as they are written.
        pub number: Option<u8>,
        /// The first byte of the area.
        pub address: u16,
        /// The bytes of a mailbox; process data areas are as long as what is assigned to them.
        pub size: Option<u16>,
        /// The shortest the area can get, in bytes.
        pub min_size: Option<u16>,
        /// The longest the area can get, in bytes.
        pub max_size: Option<u16>,
        /// The control byte.
        pub control: Option<u8>,
        /// Whether it is on; if absent, it is if it has something to carry.
        pub enable: Option<bool>,
        /// Whether it is on in Operational only.
        #[serde(default)]
        pub op_only: bool,
        /// Whether it is there for configuration tools only, and no sync manager of the controller stands behind it.
        #[serde(default)]
        pub r#virtual: bool,
        /// The PDOs assigned at start-up.
        #[serde(default)]
        pub pdos: Vec<String>,
        /// How many PDOs can be assigned at once; as many as there are by default.
        pub slots: Option<u8>,
    }
}
