//! What a way to keep time with the master makes of the sync managers.

use serde::Deserialize;
use serde::de::{Deserializer, Error};

use super::keyed::{keyed, list};
use super::shorthand::shorthand;
use super::{Index, model};
use crate::source::keys;

model! {
    /// What a sync manager does in a way to keep time, other than by default.
    pub struct ModeManager by id {
        /// The word for the sync manager.
        pub id: String,
        /// The PDOs that it carries, in order; those of the default if there are none.
        pub pdos: Vec<ModePdo>,
        /// The type of synchronisation, which ESI files state of process data: the value of subindex 1 of 0x1C32 or 0x1C33.
        pub sync_type: Option<u16>,
    }

    /// A PDO that a sync manager carries in a way to keep time.
    pub struct ModePdo by pdo {
        /// Its index.
        pub pdo: Index,
        /// How often it is there one after the other, each time with a new value.
        pub oversampling: Option<u16>,
    }
}

list! {
    /// What sync managers do in a way to keep time, by the word for them.
    ModeManagers of ModeManager as Described;
}

/// The PDOs of a sync manager, and how it is synchronised.
#[derive(Debug, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "ModeManagerTable"))]
#[serde(rename_all = "kebab-case")]
pub(crate) struct Described {
    /// The PDOs that it carries, in order; those of the default if absent.
    #[serde(default)]
    pdos: Vec<DescribedPdo>,
    /// The type of synchronisation: the value of subindex 1 of 0x1C32 or 0x1C33.
    sync_type: Option<u16>,
}

/// A PDO by its index, or a table with what else is to be said of it.
#[derive(Debug, Default)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "ModePdoTable", transform = super::schema::or_text))]
pub(crate) struct DescribedPdo {
    /// Its index.
    pdo: String,
    /// How often it is there one after the other, each time with a new value.
    oversampling: Option<u16>,
}

#[derive(Deserialize)]
struct PdoTable {
    pdo: String,
    oversampling: Option<u16>,
}

impl<'de> Deserialize<'de> for DescribedPdo {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let PdoTable { pdo, oversampling } =
            shorthand(deserializer, "pdo", "the index of a PDO, or a table with a `pdo`")?;
        Ok(Self { pdo, oversampling })
    }
}

impl<'de> Deserialize<'de> for ModeManagers {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let managers: Vec<(String, Described)> = keyed(deserializer)?;
        let manager = |(id, Described { pdos, sync_type }): (String, Described)| {
            let pdos = pdos.into_iter().map(pdo::<D::Error>).collect::<Result<_, _>>()?;
            Ok(ModeManager { id, pdos, sync_type })
        };
        managers.into_iter().map(manager).collect::<Result<_, D::Error>>().map(Self)
    }
}

fn pdo<E: Error>(described: DescribedPdo) -> Result<ModePdo, E> {
    let DescribedPdo { pdo, oversampling } = described;
    let index = keys::number(&pdo).and_then(|number| u16::try_from(number).ok());
    let wrong =
        || E::custom(format!("`{pdo}` means nothing here, expected the index of a PDO such as \"0x1A00\""));
    Ok(ModePdo { pdo: Index(index.ok_or_else(wrong)?), oversampling })
}
