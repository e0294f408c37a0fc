//! What the device is: `[device]`.

use super::raw;
use crate::model::Translations;

raw! {
    /// `[device]`: how the drive is named and grouped.
    pub struct RawHead {
        /// The name people order it by.
        pub name: String,
        /// The name in other languages, by language: `{ de = "..." }`.
        #[serde(default)]
        pub names: Translations,
        /// The vendor's name.
        pub vendor: String,
        /// What it is, in one line.
        pub title: Option<String>,
        /// What it is, in a paragraph.
        pub about: Option<String>,
        /// The order numbers that share this description.
        #[serde(default)]
        pub models: Vec<String>,
        /// The group a configuration tool lists it under; the vendor's name for its drives.
        pub group: Option<String>,
        /// The type as an ESI names it, without spaces; made from the name if absent.
        pub type_name: Option<String>,
        /// The device profile it follows, 402 for drives.
        pub profile: Option<u32>,
        /// One letter for each of up to four ports as ESI wants it: `Y` for MII (RJ45), `K` for LVDS (E-Bus), `H` for MII
        /// with fast hot connect, a space for none.
        pub physics: Option<String>,
        /// The current that it takes from the E-bus, in milliamperes; what it gives if negative.
        pub ebus_current: Option<i32>,
        /// Whether masters must read and write process data with a command each (LRD, LWR), because the device does not bear
        /// the one that does both (LRW).
        #[serde(default)]
        pub no_lrw: bool,
        /// Where to read about it.
        pub url: Option<String>,
        /// Where to read about it in other languages, by language.
        #[serde(default)]
        pub urls: Translations,
        /// A picture of 16 by 14 points that tools show beside its name, a BMP file in the folder of the description; the ESI holds it.
        pub image: Option<String>,
        /// What is in that file.
        #[serde(skip)]
        pub image_bytes: Option<Vec<u8>>,
    }
}
