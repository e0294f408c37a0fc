//! What can go wrong in the drive.

use super::table::table;
use super::{Meanings, Place, Section};

table! {
    /// `[errors.<code>]` or `[errors."<code>..=<code>"]`: an error code of object 0x603F.
    pub struct ErrorCode by code to last: "an error code such as 0x7121, or a range of them" {
        /// The code, or the first of the range.
        #[serde(skip_deserializing)]
        pub code: u16,
        /// The last of the range; the code itself if it is no range.
        #[serde(skip_deserializing)]
        pub last: u16,
        /// The word for it.
        #[serde(skip_deserializing)]
        pub id: String,
        /// Its name.
        pub name: String,
        /// The error register that comes with it.
        pub register: Option<u8>,
        /// The vendor's own codes for it.
        #[serde(default)]
        pub vendor_codes: Vec<u32>,
        /// How bad it is, in the vendor's classes, such as `"warning"` or `"1"`.
        pub severity: Option<String>,
        /// Whether it can be reset without switching the drive off.
        pub resettable: Option<bool>,
        /// What the drive's display shows, such as `"E101.0"`.
        pub panel: Option<String>,
        /// What it means.
        pub about: Option<String>,
        /// What to do about it.
        pub remedy: Option<String>,
    }

    /// `[vendor-codes.<code>]`: a code of the vendor's own system.
    pub struct VendorCode by code: "a code of the vendor's system" {
        /// The code.
        #[serde(skip_deserializing)]
        pub code: u32,
        /// Its name.
        pub name: String,
        /// How bad it is, in the vendor's classes, such as `"warning"` or `"1"`.
        pub severity: Option<String>,
        /// Whether it can be reset without switching the drive off.
        pub resettable: Option<bool>,
        /// What the drive's display shows, such as `"E101.0"`.
        pub panel: Option<String>,
        /// What it means.
        pub about: Option<String>,
        /// What can have caused it, by the number that the device gives the cause.
        #[serde(default)]
        pub causes: Meanings,
    }
}

impl ErrorCode {
    /// What a statement about it is about.
    pub fn place(&self) -> Place {
        Section::Errors.at(format_args!("{}..={}", self.code, self.last))
    }

    /// Whether it stands for more than one code.
    pub fn is_range(&self) -> bool {
        self.code != self.last
    }
}
