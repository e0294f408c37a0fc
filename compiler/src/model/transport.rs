//! What carries data between master and device.

use super::table::{part, table};
use super::{Direction, Hex, Index, Source, model};
use crate::source::Origin;

model! {
    /// A memory area of the EtherCAT slave controller.
    pub struct SyncManager by id {
        /// The word for it.
        pub id: String,
        /// Its number: its place among the sync managers.
        pub number: u8,
        /// What it is for.
        pub role: Role,
        /// The first byte of the area.
        pub address: u16,
        /// The shortest the area can get, in bytes.
        pub min_size: Option<u16>,
        /// The bytes of a mailbox, or of the default process image.
        pub size: u16,
        /// The longest the area can get, in bytes.
        pub max_size: Option<u16>,
        /// The control byte.
        pub control: u8,
        /// Whether it is on.
        pub enable: bool,
        /// Whether it is on in Operational only.
        pub op_only: bool,
        /// Whether it is there for configuration tools only, and no sync manager of the controller stands behind it.
        pub r#virtual: bool,
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
        /// Whether the device tells by upload what its PDOs map, and a master is to ask.
        pub pdo_upload: Option<bool>,
        /// Whether the device routes ADS messages, with AoE.
        pub aoe_router: Option<bool>,
        /// Whether the device makes its own net id, with AoE.
        pub aoe_generates_net_id: Option<bool>,
        /// Whether a master sets the net id of the device, with AoE.
        pub aoe_initialize_net_id: Option<bool>,
        /// Whether a master can set the IP address of the device, with EoE.
        pub eoe_ip: Option<bool>,
        /// Whether a master can set the MAC address of the device, with EoE.
        pub eoe_mac: Option<bool>,
    }

    /// `[eeprom]`: the SII EEPROM.
    pub struct Eeprom {
        /// Its size in bytes; 2048 if absent.
        #[serde(default = "usual_size")]
        pub size: u32,
        /// The first bytes of it, PDI control and what follows, in hexadecimal.
        #[serde(default)]
        pub config_data: Hex,
        /// Where the mailbox lies in the state Bootstrap, in hexadecimal: address and size of what the master writes, then of
        /// what it reads, each the low byte first. A device that says nothing here does not have the state.
        #[serde(default)]
        pub bootstrap: Hex,
    }
}

part! {
    /// A protocol of the mailbox.
    #[derive(Copy, Eq)]
    pub enum Protocol {
        /// ADS, Beckhoff's protocol between automation devices.
        #[serde(rename = "AoE")]
        Aoe,
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
            Self::Aoe => "AoE",
            Self::Coe => "CoE",
            Self::Eoe => "EoE",
            Self::Foe => "FoE",
            Self::Soe => "SoE",
            Self::Voe => "VoE",
        }
    }
}

impl Eeprom {
    /// Whether the description says anything of it.
    pub fn is_described(&self) -> bool {
        ["size", "config-data", "bootstrap"].into_iter().any(|key| self.origin.has(key))
    }

    /// Address and size of the mailbox in Bootstrap, from the master and to it.
    pub fn boot_mailbox(&self) -> Option<[(u16, u16); 2]> {
        let [a, b, c, d, e, f, g, h] = *self.bootstrap.0.as_slice() else { return None };
        let area = |address, size| (u16::from_le_bytes(address), u16::from_le_bytes(size));
        Some([area([a, b], [c, d]), area([e, f], [g, h])])
    }

    /// The size of the devices of most vendors, in bytes.
    pub const USUAL_SIZE: u32 = 2048;

    /// What its size is counted in: 1 KiBit.
    pub const UNIT: u32 = 128;

    /// The most that a slave controller reads: 4 MiBit.
    pub const MOST: u32 = 4 * 1024 * Self::UNIT;

    /// Whether an EEPROM can have its size.
    pub fn is_possible(&self) -> bool {
        self.size.is_multiple_of(Self::UNIT) && (Self::UNIT..=Self::MOST).contains(&self.size)
    }
}

impl SyncManager {
    /// The longest that one buffer of it can get, in bytes.
    pub fn longest(&self) -> u32 {
        self.max_size.unwrap_or(self.size).max(self.size).into()
    }

    /// How many buffers the control byte asks for: bits 0 and 1 are 0 for three, 2 for one.
    pub fn buffers(&self) -> u32 {
        if self.control & 0b11 == 0 { 3 } else { 1 }
    }

    /// The first byte behind all buffers at their longest.
    pub fn end(&self) -> u32 {
        u32::from(self.address) + self.buffers() * self.longest()
    }

    /// The object that names the PDOs that it carries, ETG.1000.6.
    pub fn assignment(&self) -> Index {
        Index(0x1C10_u16.saturating_add(self.number.into()))
    }
}

impl Role {
    /// All of them, in their usual order.
    pub const ALL: [Self; 4] = [Self::MailboxOut, Self::MailboxIn, Self::Outputs, Self::Inputs];

    /// The control byte that ETG.1000.4 gives a sync manager of this role.
    pub fn usual_control(self) -> u8 {
        match self {
            Self::MailboxOut => 0x26,
            Self::MailboxIn => 0x22,
            Self::Outputs => 0x64,
            Self::Inputs => 0x20,
        }
    }

    /// That of the process data of a direction.
    pub fn of(direction: Direction) -> Self {
        match direction {
            Direction::Rx => Self::Outputs,
            Direction::Tx => Self::Inputs,
        }
    }

    /// The number of its kind in 0x1C00, as ETG.1000.6 has it.
    pub fn kind(self) -> u8 {
        match self {
            Self::MailboxOut => 1,
            Self::MailboxIn => 2,
            Self::Outputs => 3,
            Self::Inputs => 4,
        }
    }

    /// Whether it carries process data, not mail.
    pub fn is_process_data(self) -> bool {
        matches!(self, Self::Outputs | Self::Inputs)
    }

    /// Whether the master writes what it carries.
    pub fn is_written(self) -> bool {
        matches!(self, Self::MailboxOut | Self::Outputs)
    }

    /// The word for it, and the key in `[sync-managers]` of a sync manager that is the only one of its role.
    pub fn key(self) -> &'static str {
        match self {
            Self::MailboxOut => "mailbox-out",
            Self::MailboxIn => "mailbox-in",
            Self::Outputs => "outputs",
            Self::Inputs => "inputs",
        }
    }
}
