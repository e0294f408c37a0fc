//! Choices of process data and mode, with the start-up list that follows from them.

use super::{Address, Direction, Duration, Index, Pdo, Source, Value, model};
use crate::source::{Location, Origin};

model! {
    /// What a master chooses before it goes to Safe-Operational.
    pub struct Configuration by id {
        /// The word for it.
        pub id: String,
        /// What it is good for.
        pub name: String,
        /// Whether a master takes it if nothing else is chosen.
        pub default: bool,
        /// The PDOs to assign to the outputs, by index; untouched if none.
        pub outputs: Option<Vec<Index>>,
        /// The PDOs to assign to the inputs, by index; untouched if none.
        pub inputs: Option<Vec<Index>>,
        /// The PDOs that are mapped anew, as they are mapped here.
        pub mapping: Vec<Pdo>,
        /// The mode of operation.
        pub mode: Option<i16>,
        /// The cycle time.
        #[cfg_attr(feature = "json", serde(rename = "cycle_ns"))]
        pub cycle_time: Option<Duration>,
        /// Other values that are written; they are among `startup`.
        #[cfg_attr(feature = "json", serde(skip))]
        pub writes: Vec<ChosenWrite>,
        /// The writes that bring it about, in order.
        pub startup: Vec<SdoWrite>,
        /// What else is to be said.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(rename = "provenance"))]
        pub origin: Origin,
    }

    /// A value that a configuration writes as it says itself.
    pub struct ChosenWrite {
        /// What it writes.
        pub value: Value,
        /// The same as it travels.
        pub write: SdoWrite,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub at: Location,
    }

    /// A write through the mailbox.
    #[derive(Eq)]
    pub struct SdoWrite {
        /// The change of the EtherCAT state during which it is made.
        pub transition: String,
        /// Where to.
        pub address: Address,
        /// What, as it travels: little-endian.
        pub data: Vec<u8>,
        /// What for.
        pub comment: String,
    }
}

impl Configuration {
    /// Whether anything is not as it is without it.
    pub fn chooses_anything(&self) -> bool {
        let Self { outputs, inputs, mapping, mode, cycle_time, writes, .. } = self;
        outputs.is_some()
            || inputs.is_some()
            || !mapping.is_empty()
            || mode.is_some()
            || cycle_time.is_some()
            || !writes.is_empty()
    }

    /// The PDOs to assign of a direction; untouched if none.
    pub fn assigned(&self, direction: Direction) -> Option<&[Index]> {
        match direction {
            Direction::Rx => self.outputs.as_deref(),
            Direction::Tx => self.inputs.as_deref(),
        }
    }
}
