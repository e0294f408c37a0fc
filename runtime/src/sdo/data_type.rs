//! The types of entries, by number.

use core::fmt;

/// The number of a data type in the dictionary (CiA 301, data type definitions; ETG.1000.6, basic data types).
///
/// Devices may define their own from 0x0040 on, so every number is a type.
///
/// ```
/// use devc_runtime::sdo::DataType;
///
/// assert_eq!(DataType::INTEGER32.to_string(), "INTEGER32");
/// assert_eq!(DataType(0x0800).to_string(), "0x0800");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DataType(pub u16);

macro_rules! data_types {
    ($($name:ident = $number:literal, $meaning:literal;)+) => {
        impl DataType {
            $(
                #[doc = $meaning]
                pub const $name: Self = Self($number);
            )+

            /// The standard's name, if it is a basic type.
            pub const fn name(self) -> Option<&'static str> {
                match self {
                    $(Self::$name => Some(stringify!($name)),)+
                    _ => None,
                }
            }
        }
    };
}

data_types! {
    BOOLEAN = 0x0001, "True or false; one bit in process data, one byte in an SDO.";
    INTEGER8 = 0x0002, "Signed, 1 byte.";
    INTEGER16 = 0x0003, "Signed, 2 bytes.";
    INTEGER32 = 0x0004, "Signed, 4 bytes.";
    UNSIGNED8 = 0x0005, "Unsigned, 1 byte.";
    UNSIGNED16 = 0x0006, "Unsigned, 2 bytes.";
    UNSIGNED32 = 0x0007, "Unsigned, 4 bytes.";
    REAL32 = 0x0008, "Floating point, 4 bytes.";
    VISIBLE_STRING = 0x0009, "Text.";
    OCTET_STRING = 0x000A, "Bytes of any meaning.";
    UNICODE_STRING = 0x000B, "Text in 16-bit units.";
    INTEGER24 = 0x0010, "Signed, 3 bytes.";
    REAL64 = 0x0011, "Floating point, 8 bytes.";
    INTEGER40 = 0x0012, "Signed, 5 bytes.";
    INTEGER48 = 0x0013, "Signed, 6 bytes.";
    INTEGER56 = 0x0014, "Signed, 7 bytes.";
    INTEGER64 = 0x0015, "Signed, 8 bytes.";
    UNSIGNED24 = 0x0016, "Unsigned, 3 bytes.";
    UNSIGNED40 = 0x0018, "Unsigned, 5 bytes.";
    UNSIGNED48 = 0x0019, "Unsigned, 6 bytes.";
    UNSIGNED56 = 0x001A, "Unsigned, 7 bytes.";
    UNSIGNED64 = 0x001B, "Unsigned, 8 bytes.";
}

impl DataType {
    /// Whether its values may be shorter than their entries: texts, and bytes of any meaning.
    pub const fn is_text(self) -> bool {
        matches!(self, Self::VISIBLE_STRING | Self::OCTET_STRING | Self::UNICODE_STRING)
    }

    /// Whether its values have a sign.
    pub const fn is_signed(self) -> bool {
        matches!(
            self,
            Self::INTEGER8
                | Self::INTEGER16
                | Self::INTEGER24
                | Self::INTEGER32
                | Self::INTEGER40
                | Self::INTEGER48
                | Self::INTEGER56
                | Self::INTEGER64
        )
    }
}

impl fmt::Display for DataType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.name() {
            Some(name) => f.write_str(name),
            None => write!(f, "0x{:04X}", self.0),
        }
    }
}
