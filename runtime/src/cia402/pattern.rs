//! Bits that count and bits that do not.

use core::fmt;

/// A pattern of a word, as the tables of CiA 402 have them: bits that must be 0, bits that must be 1, and bits that
/// do not count (`x`).
///
/// ```
/// use devc_runtime::cia402::Pattern;
///
/// let shutdown = Pattern { mask: 0x0087, value: 0x0006 };
/// assert_eq!(shutdown.to_string(), "xxxx xxxx 0xxx x110");
/// assert!(shutdown.matches(0x000E));
/// assert_eq!(shutdown.apply(0x010F), 0x010E);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Pattern {
    /// The bits that count.
    pub mask: u16,
    /// What they have to be; the others are 0 here.
    pub value: u16,
}

impl Pattern {
    /// Whether all bits of `word` that count are as they have to be (CiA 402, state coding).
    #[inline]
    pub const fn matches(self, word: u16) -> bool {
        word & self.mask == self.value
    }

    /// The word with the bits that count set as they have to be, and all others as they were.
    #[inline]
    #[must_use]
    pub const fn apply(self, word: u16) -> u16 {
        word & !self.mask | self.value
    }

    /// Whether some word matches both patterns.
    pub const fn overlaps(self, other: Self) -> bool {
        (self.value ^ other.value) & self.mask & other.mask == 0
    }
}

impl fmt::Display for Pattern {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for bit in (0..16_u32).rev() {
            let is_set = |word: u16| word.wrapping_shr(bit) & 1 == 1;
            f.write_str(match (is_set(self.mask), is_set(self.value)) {
                (false, _) => "x",
                (true, false) => "0",
                (true, true) => "1",
            })?;
            if matches!(bit, 4 | 8 | 12) {
                f.write_str(" ")?;
            }
        }
        Ok(())
    }
}
