//! Pictures of devices.

use super::{Hex, model};

model! {
    /// A picture of 16 by 14 points.
    pub struct Picture {
        /// The file that it was read from, by the name that the description gives.
        pub file: String,
        /// The bytes of the file.
        pub bytes: Hex,
    }
}
