//! The object dictionary.

use super::table::part;
use super::{
    Address, DataType, Direction, Effective, Index, Meanings, Safety, SdoAccess, Source, Stored,
    Translations, Value, model,
};
use crate::source::Origin;

model! {
    /// An object: an index, and one value or several under it.
    pub struct Object by index {
        /// Its index.
        pub index: Index,
        /// The index of the object that was written for all axes; its own if it is there once.
        pub leading: Index,
        /// The word by which it is referred to; the same on every axis.
        pub id: String,
        /// Its name.
        pub name: String,
        /// Its name in other languages, by language.
        pub names: Translations,
        /// What it is made of.
        pub kind: Kind,
        /// The axis it belongs to, if it exists once for each.
        pub axis: Option<u8>,
        /// Whether a profile demands it.
        pub category: Category,
        /// What it is for.
        pub about: Option<String>,
        /// What else is to be said of it here.
        pub note: Option<String>,
        /// False if it exists for compatibility only and does nothing.
        pub functional: bool,
        /// The vendor's own name of the parameter behind it.
        pub parameter: Option<String>,
        /// What the vendor's tools are told of it.
        pub properties: Vec<Property>,
        /// How its entries are to be transferred, if it is not left to the master.
        pub sdo_access: Option<SdoAccess>,
        /// The entries by subindex; subindex 0 is always there.
        pub entries: Vec<Entry>,
        /// Whether it follows from the PDOs and the sync managers.
        pub derived: bool,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(rename = "provenance"))]
        pub origin: Origin,
    }

    /// A value that an index and a subindex name.
    pub struct Entry by address {
        /// Its address.
        pub address: Address,
        /// The word for it, unique within the object.
        pub id: String,
        /// Its name.
        pub name: String,
        /// Its name in other languages, by language.
        pub names: Translations,
        /// Its type.
        pub data_type: DataType,
        /// Who may read and write it.
        pub access: Access,
        /// The process data it can be mapped to.
        pub pdo: Mappable,
        /// What it is to the safety of a machine, if it is anything.
        pub safety: Option<Safety>,
        /// Whether a profile demands it.
        pub category: Category,
        /// The unit of its value, by id.
        pub unit: Option<String>,
        /// The value after start-up.
        pub default: Option<Value>,
        /// The least value.
        pub min: Option<Value>,
        /// The greatest value.
        pub max: Option<Value>,
        /// What single values mean.
        pub values: Meanings,
        /// The EtherCAT states in which it may be written; any in which there is a mailbox if none.
        pub written: Option<WriteWindow>,
        /// Whether a tool saves it, to write it to a device that takes this one's place.
        pub backup: bool,
        /// Whether it is one of the settings of an application.
        pub setting: bool,
        /// When a new value takes effect.
        pub effective: Option<Effective>,
        /// Whether the device keeps it when it is switched off.
        pub stored: Option<Stored>,
        /// What it is for.
        pub about: Option<String>,
        /// What else is to be said of it here.
        pub note: Option<String>,
        /// False if it exists for compatibility only and does nothing.
        pub functional: bool,
        /// What writing it sets off.
        pub trigger: Option<Trigger>,
        /// The vendor's own name of the parameter behind it.
        pub parameter: Option<String>,
        /// What the vendor's tools are told of it.
        pub properties: Vec<Property>,
        /// Where its facts are from, if not where the object's are.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(rename = "provenance"))]
        pub origin: Origin,
    }

    /// What writing a value sets off.
    pub struct Trigger {
        /// The value to write.
        pub value: Value,
        /// What it does.
        pub action: String,
        /// The mode of operation that must be active.
        pub mode: Option<i16>,
        /// The objects that it takes its data from.
        pub uses: Vec<Address>,
        /// The objects that it changes.
        pub updates: Vec<Address>,
    }
}

part! {
    /// Something that the vendor's tools are told.
    #[derive(Default)]
    pub struct Property {
        /// What it is called.
        pub name: String,
        /// What it is.
        pub value: Option<String>,
        /// What that means.
        pub about: Option<String>,
    }

    /// What an object is made of.
    #[derive(Copy, Eq)]
    pub enum Kind {
        /// One value at subindex 0.
        Var,
        /// Values of one type from subindex 1 on.
        Array,
        /// Values of different types from subindex 1 on.
        Record,
    }

    /// Who may read and write a value.
    #[derive(Copy, Eq, Default)]
    pub enum Access {
        /// Read only.
        #[default]
        Ro,
        /// Write only.
        Wo,
        /// Read and write.
        Rw,
        /// Read only and never different.
        Const,
    }

    /// The process data a value can be mapped to.
    #[derive(Copy, Eq, Default)]
    pub enum Mappable {
        /// None.
        #[default]
        None,
        /// What the master sends.
        Rx,
        /// What the device sends.
        Tx,
        /// Both.
        RxTx,
    }

    /// The EtherCAT states in which a value may be written, of those in which there is a mailbox.
    #[derive(Copy, Eq)]
    pub enum WriteWindow {
        /// Pre-Operational, so before the transition `PS`.
        PreOp,
        /// Pre-Operational and Safe-Operational.
        PreOpSafeOp,
        /// Pre-Operational and Operational.
        PreOpOp,
        /// Safe-Operational, so before the transition `SO`.
        SafeOp,
        /// Safe-Operational and Operational.
        SafeOpOp,
        /// Operational.
        Op,
    }

    /// Whether a profile demands an object.
    #[derive(Copy, Eq, Default)]
    pub enum Category {
        /// Always.
        Mandatory,
        /// Never.
        #[default]
        Optional,
        /// If something else is there.
        Conditional,
    }
}

impl WriteWindow {
    /// Its name in an ESI file, ETG.2000.
    pub fn name(self) -> &'static str {
        match self {
            Self::PreOp => "PreOP",
            Self::PreOpSafeOp => "PreOP_SafeOP",
            Self::PreOpOp => "PreOP_OP",
            Self::SafeOp => "SafeOP",
            Self::SafeOpOp => "SafeOP_OP",
            Self::Op => "OP",
        }
    }

    /// Whether the states are among them: Pre-Operational, Safe-Operational, Operational.
    pub fn states(self) -> [bool; 3] {
        match self {
            Self::PreOp => [true, false, false],
            Self::PreOpSafeOp => [true, true, false],
            Self::PreOpOp => [true, false, true],
            Self::SafeOp => [false, true, false],
            Self::SafeOpOp => [false, true, true],
            Self::Op => [false, false, true],
        }
    }
}

impl Entry {
    /// What subindex 0 of several values is called, unless a description says it.
    pub const COUNT: &str = "Highest subindex supported";
}

impl Object {
    /// The entry of this subindex.
    pub fn entry(&self, subindex: u8) -> Option<&Entry> {
        let place = self.entries.binary_search_by_key(&subindex, |entry| entry.address.subindex).ok()?;
        self.entries.get(place)
    }

    /// The greatest subindex there is.
    pub fn highest_subindex(&self) -> u8 {
        self.entries.last().map_or(0, |entry| entry.address.subindex)
    }
}

impl Access {
    /// Whether a master can read it.
    pub fn readable(self) -> bool {
        self != Self::Wo
    }

    /// Whether a master can write it.
    pub fn writable(self) -> bool {
        matches!(self, Self::Wo | Self::Rw)
    }
}

impl Mappable {
    /// What can be mapped to PDOs of these directions.
    pub fn of(rx: bool, tx: bool) -> Self {
        match (rx, tx) {
            (false, false) => Self::None,
            (true, false) => Self::Rx,
            (false, true) => Self::Tx,
            (true, true) => Self::RxTx,
        }
    }

    /// Whether it can be in what the master sends.
    pub fn rx(self) -> bool {
        matches!(self, Self::Rx | Self::RxTx)
    }

    /// Whether it can be in what the device sends.
    pub fn tx(self) -> bool {
        matches!(self, Self::Tx | Self::RxTx)
    }

    /// Whether it can be in PDOs of this direction.
    pub fn goes(self, direction: Direction) -> bool {
        match direction {
            Direction::Rx => self.rx(),
            Direction::Tx => self.tx(),
        }
    }
}
