//! Modes of operation: `[modes]`.

use super::raw;
use crate::model::{Fields, HomingBits, MotionCommand};

raw! {
    /// `[modes.<code>]`: a mode of operation by its code in 0x6060.
    pub struct RawMode by code: "the code of a mode of operation, such as 8 for csp" {
        /// The code in 0x6060.
        #[serde(skip)]
        pub code: i16,
        /// The word for it, such as `csp`.
        pub id: String,
        /// Its name.
        pub name: String,
        /// What the drive does in it.
        pub about: Option<String>,
        /// Other codes that select it.
        #[serde(default)]
        pub aliases: Vec<i16>,
        /// Whether the master sends a new set value every cycle.
        #[serde(default)]
        pub cyclic: bool,
        /// The bit of 0x6502 that announces it; none for modes that it does not list.
        pub supported_bit: Option<u8>,
        /// The objects that it uses.
        #[serde(default)]
        pub objects: Vec<String>,
        /// What it makes of bits of the controlword.
        #[serde(default)]
        pub control_bits: Fields,
        /// What it makes of bits of the statusword.
        #[serde(default)]
        pub status_bits: Fields,
        /// Which bits a reference run is started and followed by.
        pub homing_bits: Option<HomingBits>,
        /// What must be so before it is chosen, a sentence each.
        #[serde(default)]
        pub conditions: Vec<String>,
        /// What a user should know, a sentence each; what can do damage first.
        #[serde(default)]
        pub cautions: Vec<String>,
        /// The motion commands that the drive runs for it.
        #[serde(default)]
        pub commands: Vec<MotionCommand>,
    }
}
