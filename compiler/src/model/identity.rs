//! Who a device is, and what of it a master compares before it takes it for the one that it was set up for.

use super::table::{part, table};

table! {
    /// `[identity]`: what the identity object 0x1018 and the EEPROM say.
    pub struct Identity {
        /// The vendor id that the ETG assigned.
        pub vendor_id: u32,
        /// The product code.
        pub product_code: u32,
        /// The revision number.
        pub revision: u32,
        /// The serial number of a device that has none of its own; 0 if absent.
        #[serde(default)]
        pub serial: u32,
        /// The revisions that it takes the place of, so that tools no longer offer them.
        #[serde(default)]
        pub replaces: Vec<u32>,
        /// What product code a master accepts in its place; the same one if absent.
        pub check_product_code: Option<CheckedCode>,
        /// What revisions a master accepts in its place; what the master is set to if absent.
        pub check_revision: Option<CheckedRevision>,
        /// Whether a master can ask for the number that people set at the device: it sets bit 5 of AL control, and the AL
        /// status code is the answer (ETG.1020).
        #[serde(default)]
        pub requested_id: bool,
        /// The address in the slave controller at which a master reads that number without asking.
        pub id_address: Option<u16>,
    }
}

part! {
    /// Which product codes are as good as this one.
    #[derive(Copy, Eq)]
    pub enum CheckedCode {
        /// Any.
        None,
        /// The same.
        Equal,
    }

    /// Which revisions are as good as this one. The low word and the high word of the revision can be compared apart.
    #[derive(Copy, Eq)]
    pub enum CheckedRevision {
        /// Any.
        None,
        /// The same.
        Equal,
        /// The same and later ones.
        EqualOrGreater,
        /// Those of the same low word.
        LowWordEqual,
        /// Those of the same low word, with the same or a greater high word.
        LowWordEqualHighWordEqualOrGreater,
        /// Those of the same high word.
        HighWordEqual,
        /// Those of the same high word, with the same or a greater low word.
        HighWordEqualLowWordEqualOrGreater,
    }
}

impl CheckedCode {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::None, Self::Equal];

    /// Its name in an ESI file, ETG.2000.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "NONE",
            Self::Equal => "EQ",
        }
    }

    /// The word for it in a description.
    pub fn word(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Equal => "equal",
        }
    }
}

impl CheckedRevision {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::None,
        Self::Equal,
        Self::EqualOrGreater,
        Self::LowWordEqual,
        Self::LowWordEqualHighWordEqualOrGreater,
        Self::HighWordEqual,
        Self::HighWordEqualLowWordEqualOrGreater,
    ];

    /// Its name in an ESI file, ETG.2000.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "NONE",
            Self::Equal => "EQ",
            Self::EqualOrGreater => "EQ_OR_G",
            Self::LowWordEqual => "LW_EQ",
            Self::LowWordEqualHighWordEqualOrGreater => "LW_EQ_HW_EQ_OR_G",
            Self::HighWordEqual => "HW_EQ",
            Self::HighWordEqualLowWordEqualOrGreater => "HW_EQ_LW_EQ_OR_G",
        }
    }

    /// The word for it in a description.
    pub fn word(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Equal => "equal",
            Self::EqualOrGreater => "equal-or-greater",
            Self::LowWordEqual => "low-word-equal",
            Self::LowWordEqualHighWordEqualOrGreater => "low-word-equal-high-word-equal-or-greater",
            Self::HighWordEqual => "high-word-equal",
            Self::HighWordEqualLowWordEqualOrGreater => "high-word-equal-low-word-equal-or-greater",
        }
    }
}
