//! Numbers, bytes and prose as ESI spells them.

use std::fmt;

pub(super) use crate::emit::escape::prose;

/// A number in hexadecimal with all digits of its type, as `#x6040`.
pub(super) struct Hex<T>(pub(super) T);

impl fmt::Display for Hex<u8> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#x{:02X}", self.0)
    }
}

impl fmt::Display for Hex<u16> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#x{:04X}", self.0)
    }
}

impl fmt::Display for Hex<u32> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#x{:08X}", self.0)
    }
}

/// Bytes as the schemas' `hexBinary`, as `4041`.
pub(super) struct Bytes<'a>(pub(super) &'a [u8]);

impl fmt::Display for Bytes<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02X}"))
    }
}
