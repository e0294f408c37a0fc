//! What can go wrong in the drive.

use super::{Meaning, Source, model};
use crate::source::Origin;

model! {
    /// An error code of object 0x603F, or a range of them.
    pub struct ErrorCode {
        /// The code, or the first of the range.
        pub code: u16,
        /// The last of the range; the code itself if it is no range.
        pub last: u16,
        /// The word for it.
        pub id: String,
        /// Its name.
        pub name: String,
        /// The error register that comes with it.
        pub register: Option<u8>,
        /// The vendor's own codes for it.
        pub vendor_codes: Vec<u32>,
        /// What it means.
        pub about: Option<String>,
        /// What to do about it.
        pub remedy: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }

    /// A code of the vendor's own system.
    pub struct VendorCode {
        /// The code.
        pub code: u32,
        /// Its name.
        pub name: String,
        /// What it means.
        pub about: Option<String>,
        /// What can have caused it, by the number that the device gives the cause.
        pub causes: Vec<Meaning>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(skip))]
        pub origin: Origin,
    }
}

impl ErrorCode {
    /// Whether it stands for more than one code.
    pub fn is_range(&self) -> bool {
        self.code != self.last
    }
}
