//! What carries data between master and device.

use super::{Index, Source, model};
use crate::source::Origin;

model! {
    /// A memory area of the EtherCAT slave controller.
    pub struct SyncManager {
        /// What it is for; its number follows.
        pub role: Role,
        /// The first byte of the area.
        pub address: u16,
        /// The bytes of a mailbox, or of the default process image.
        pub size: u16,
        /// The longest the area can get, in bytes.
        pub max_size: Option<u16>,
        /// The control byte.
        pub control: u8,
        /// The PDOs assigned at start-up, by index.
        pub pdos: Vec<Index>,
        /// How many PDOs can be assigned at once.
        pub slots: u8,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }

    /// What a sync manager is for.
    #[derive(Copy, Eq, PartialOrd, Ord)]
    #[cfg_attr(feature = "json", serde(rename_all = "snake_case"))]
    pub enum Role {
        /// Mail from the master.
        MailboxOut,
        /// Mail to the master.
        MailboxIn,
        /// Process data from the master.
        Outputs,
        /// Process data to the master.
        Inputs,
    }

    /// What the mailbox can do.
    pub struct Mailbox {
        /// The protocols: `CoE`, `EoE`, `FoE`, `SoE`, `VoE`.
        pub protocols: Vec<String>,
        /// Whether the dictionary can be read out.
        pub sdo_info: bool,
        /// Whether the master may write 0x1C12 and 0x1C13.
        pub pdo_assign: bool,
        /// Whether the master may write the mapping objects.
        pub pdo_config: bool,
        /// Whether all subindices can be transferred at once.
        pub complete_access: bool,
        /// Whether transfers longer than the mailbox are possible.
        pub segmented: bool,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }

    /// The SII EEPROM.
    pub struct Eeprom {
        /// Its size in bytes.
        pub size: u32,
        /// The first bytes of it: PDI control and what follows.
        pub config_data: Vec<u8>,
    }
}

impl Role {
    /// All of them, by number.
    pub const ALL: [Self; 4] = [Self::MailboxOut, Self::MailboxIn, Self::Outputs, Self::Inputs];

    /// The number of the sync manager.
    pub fn number(self) -> u8 {
        self as u8
    }

    /// The key in `[sync-managers]`.
    pub fn key(self) -> &'static str {
        match self {
            Self::MailboxOut => "mailbox-out",
            Self::MailboxIn => "mailbox-in",
            Self::Outputs => "outputs",
            Self::Inputs => "inputs",
        }
    }
}
