//! What carries data between master and device.

use super::table::{part, table};
use super::{Direction, Hex, Index, Source, model};
use crate::source::Origin;

model! {
    /// A memory area of the EtherCAT slave controller.
    pub struct SyncManager by role {
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
        #[cfg_attr(feature = "json", serde(rename = "provenance"))]
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
}

table! {
    /// `[mailbox]`: what the mailbox can do.
    pub struct Mailbox {
        /// The protocols.
        pub protocols: Vec<Protocol>,
        /// Whether the dictionary can be read out.
        #[serde(default)]
        pub sdo_info: bool,
        /// Whether the master may write 0x1C12 and 0x1C13.
        #[serde(default)]
        pub pdo_assign: bool,
        /// Whether the master may write the mapping objects.
        #[serde(default)]
        pub pdo_config: bool,
        /// Whether all subindices can be transferred at once.
        #[serde(default)]
        pub complete_access: bool,
        /// Whether transfers longer than the mailbox are possible.
        #[serde(default)]
        pub segmented: bool,
    }

    /// `[eeprom]`: the SII EEPROM.
    pub struct Eeprom {
        /// Its size in bytes; 2048 if absent.
        #[serde(default = "usual_size")]
        pub size: u32,
        /// The first bytes of it, PDI control and what follows, in hexadecimal.
        #[serde(default)]
        pub config_data: Hex,
    }
}

part! {
    /// A protocol of the mailbox.
    #[derive(Copy, Eq)]
    pub enum Protocol {
        /// CANopen: the object dictionary.
        #[serde(rename = "CoE")]
        Coe,
        /// Ethernet frames.
        #[serde(rename = "EoE")]
        Eoe,
        /// Files.
        #[serde(rename = "FoE")]
        Foe,
        /// The drive profile SERCOS.
        #[serde(rename = "SoE")]
        Soe,
        /// A vendor's own.
        #[serde(rename = "VoE")]
        Voe,
    }
}

fn usual_size() -> u32 {
    Eeprom::USUAL_SIZE
}

impl Protocol {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Coe => "CoE",
            Self::Eoe => "EoE",
            Self::Foe => "FoE",
            Self::Soe => "SoE",
            Self::Voe => "VoE",
        }
    }
}

impl Eeprom {
    /// The size of the devices of most vendors, in bytes.
    pub const USUAL_SIZE: u32 = 2048;
}

impl Role {
    /// All of them, by number.
    pub const ALL: [Self; 4] = [Self::MailboxOut, Self::MailboxIn, Self::Outputs, Self::Inputs];

    /// That of the process data of a direction.
    pub fn of(direction: Direction) -> Self {
        match direction {
            Direction::Rx => Self::Outputs,
            Direction::Tx => Self::Inputs,
        }
    }

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
