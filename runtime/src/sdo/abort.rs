//! Why an SDO transfer was refused.

use core::fmt;

use crate::bytes::WrongLength;
use crate::codes::codes;

/// An SDO abort code (CiA 301, abort SDO transfer; ETG.1000.6, SDO abort codes).
///
/// Any number is a code: those that no standard names keep their value and have no meaning.
///
/// ```
/// use devc_runtime::sdo::AbortCode;
///
/// assert_eq!(AbortCode::NO_SUCH_OBJECT.to_string(), "0x06020000: the object is not in the dictionary");
/// assert_eq!(AbortCode(0x1234_5678).to_string(), "0x12345678: unknown abort code");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct AbortCode(pub u32);

codes! { AbortCode:
    TOGGLE_BIT_NOT_ALTERNATED = 0x0503_0000, "the toggle bit did not change between segments";
    TIMEOUT = 0x0504_0000, "the transfer took too long";
    UNKNOWN_COMMAND_SPECIFIER = 0x0504_0001, "the command specifier is not known";
    INVALID_BLOCK_SIZE = 0x0504_0002, "the block size is not allowed";
    INVALID_SEQUENCE_NUMBER = 0x0504_0003, "the sequence number is not allowed";
    CHECKSUM_WRONG = 0x0504_0004, "the checksum of the block is wrong";
    OUT_OF_MEMORY = 0x0504_0005, "the device has not enough memory";
    UNSUPPORTED_ACCESS = 0x0601_0000, "the object does not support this access";
    WRITE_ONLY = 0x0601_0001, "the entry can only be written";
    READ_ONLY = 0x0601_0002, "the entry can only be read";
    SUBINDEX_0_NOT_CLEARED = 0x0601_0003, "the entry can be written only while subindex 0 is 0";
    NO_COMPLETE_ACCESS = 0x0601_0004, "the object cannot be accessed as a whole";
    LONGER_THAN_MAILBOX = 0x0601_0005, "the object is longer than the mailbox";
    MAPPED_TO_RX_PDO = 0x0601_0006, "the entry is written by process data";
    NO_SUCH_OBJECT = 0x0602_0000, "the object is not in the dictionary";
    NOT_MAPPABLE = 0x0604_0041, "the entry cannot be mapped to process data";
    PDO_TOO_LONG = 0x0604_0042, "the mapped entries do not fit the process data";
    PARAMETERS_INCOMPATIBLE = 0x0604_0043, "the parameter contradicts other parameters";
    DEVICE_INCOMPATIBLE = 0x0604_0047, "the device contradicts itself internally";
    HARDWARE_ERROR = 0x0606_0000, "the hardware failed during the access";
    LENGTH_MISMATCH = 0x0607_0010, "the data has not the length of the entry";
    LENGTH_TOO_HIGH = 0x0607_0012, "the data is longer than the entry";
    LENGTH_TOO_LOW = 0x0607_0013, "the data is shorter than the entry";
    NO_SUCH_SUBINDEX = 0x0609_0011, "the object has no such subindex";
    VALUE_OUT_OF_RANGE = 0x0609_0030, "the value is not allowed";
    VALUE_TOO_HIGH = 0x0609_0031, "the value is too high";
    VALUE_TOO_LOW = 0x0609_0032, "the value is too low";
    MODULES_DIFFER = 0x0609_0033, "the configured modules are not those that were found";
    MAXIMUM_BELOW_MINIMUM = 0x0609_0036, "the maximum is below the minimum";
    RESOURCE_NOT_AVAILABLE = 0x060A_0023, "a resource for the transfer is not available";
    GENERAL_ERROR = 0x0800_0000, "an error that is not told";
    NOT_STORED = 0x0800_0020, "the application cannot take or give the data";
    LOCAL_CONTROL = 0x0800_0021, "the application is controlled locally";
    DEVICE_STATE = 0x0800_0022, "the present state of the device does not allow it";
    NO_DICTIONARY = 0x0800_0023, "there is no dictionary, or it could not be made";
    NO_DATA = 0x0800_0024, "there is no data";
}

impl fmt::Display for AbortCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "0x{:08X}: {}", self.0, self.meaning().unwrap_or("unknown abort code"))
    }
}

impl core::error::Error for AbortCode {}

impl From<WrongLength> for AbortCode {
    fn from(length: WrongLength) -> Self {
        if length.found > length.expected { Self::LENGTH_TOO_HIGH } else { Self::LENGTH_TOO_LOW }
    }
}
