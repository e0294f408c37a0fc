//! Modes of operation.

use super::table::{part, table};
use super::{Address, Fields, Source, model};
use crate::source::Origin;

model! {
    /// A mode of operation.
    pub struct Mode by code {
        /// Its code in 0x6060.
        pub code: i16,
        /// Other codes that select it.
        pub aliases: Vec<i16>,
        /// The word for it, such as `csp`.
        pub id: String,
        /// Its name.
        pub name: String,
        /// What the drive does in it.
        pub about: Option<String>,
        /// Whether the master sends a new set value every cycle.
        pub cyclic: bool,
        /// The bit of 0x6502 that announces it.
        pub supported_bit: Option<u8>,
        /// The entries that it uses, on the first axis.
        pub objects: Vec<Address>,
        /// What it makes of bits of the controlword.
        pub control_bits: Fields,
        /// What it makes of bits of the statusword.
        pub status_bits: Fields,
        /// Which bits a reference run is started and followed by.
        pub homing_bits: Option<HomingBits>,
        /// What must be so before it is chosen.
        pub conditions: Vec<String>,
        /// What a user should know.
        pub cautions: Vec<String>,
        /// The motion commands that the drive runs for it.
        pub commands: Vec<MotionCommand>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(rename = "provenance"))]
        pub origin: Origin,
    }
}

part! {
    /// The bits of a reference run, by number.
    #[derive(Copy, Eq, Default)]
    pub struct HomingBits {
        /// Of the controlword: its rising edge starts the run.
        pub start: u8,
        /// Of the statusword: the axis has come to where it should, or stands.
        pub reached: u8,
        /// Of the statusword: the reference is set.
        pub attained: u8,
        /// Of the statusword: the run has failed.
        pub error: u8,
    }

    /// A command of the motion core that a mode runs.
    pub struct MotionCommand {
        /// Its number.
        pub code: Option<u16>,
        /// Its name.
        pub name: String,
        /// The setting that chooses it within the mode.
        pub when: Option<String>,
        /// What it does.
        pub about: Option<String>,
        /// What is controlled.
        pub control: Option<String>,
        /// The motion variables it needs.
        #[serde(default)]
        pub variables: Vec<String>,
    }
}

table! {
    /// `[[mode-changes]]`: a change of mode that the device knows.
    pub struct ModeChange {
        /// The modes before, by code; any if absent.
        #[serde(default)]
        pub from: Vec<i16>,
        /// The modes after, by code; any if absent.
        #[serde(default)]
        pub to: Vec<i16>,
        /// When it has worked.
        pub done_when: Option<String>,
        /// When it ends in a fault.
        pub fault_when: Option<String>,
        /// What else is to be said.
        pub about: Option<String>,
    }

    /// `[[stop-options]]`: what stops the drive, and how.
    pub struct StopOption {
        /// What happens to the drive.
        pub action: String,
        /// The transitions it goes through, by number.
        #[serde(default)]
        pub transitions: Vec<u8>,
        /// What the drive does.
        pub reaction: String,
        /// How it slows down.
        pub ramp: Option<String>,
        /// What else is to be said.
        pub about: Option<String>,
    }
}
