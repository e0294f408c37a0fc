//! How numbers are written.

use crate::model::{Beside, Compare, Difference, FieldPath};
use crate::source::keys;

/// The notation that a number is written in, which says nothing of what the number is: two that differ in it alone are
/// the same.
#[derive(Debug, Clone, Copy, Default)]
pub enum Notation {
    /// `35`.
    #[default]
    Decimal,
    /// `0x23`.
    Hexadecimal {
        /// How many digits it has, with zeros in front.
        digits: usize,
    },
}

impl Notation {
    /// The notation of a number as it is written, or of the first of a range.
    pub(crate) fn of(written: &str) -> Self {
        let written = written.split("..").next().unwrap_or_default().trim();
        match keys::hexadecimal(written.strip_prefix('-').unwrap_or(written)) {
            Some(digits) => Self::Hexadecimal { digits: digits.len() },
            None => Self::Decimal,
        }
    }

    /// A number in this notation.
    pub fn written(self, number: i64) -> String {
        let sign = if number < 0 { "-" } else { "" };
        match self {
            Self::Decimal => number.to_string(),
            Self::Hexadecimal { digits } => format!("{sign}0x{:0digits$X}", number.unsigned_abs()),
        }
    }

    fn digits(self) -> Option<usize> {
        match self {
            Self::Decimal => None,
            Self::Hexadecimal { digits } => Some(digits),
        }
    }
}

impl PartialEq for Notation {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// A number is the same however it is written, but does not look the same.
impl Compare for Notation {
    fn shown(&self) -> String {
        String::new()
    }

    fn is_told_alike(&self, other: &Self, _: &dyn Beside) -> bool {
        self.digits() == other.digits()
    }

    fn compare(&self, _: &Self, _: &mut FieldPath, _: &mut dyn FnMut(Difference)) {}
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_shown_as_it_is_written() {
        for (number, text) in
            [(35, "0x23"), (0, "0x00"), (35, "35"), (-35, "-0x23"), (-5, "-5"), (43, "0x2B")]
        {
            assert_eq!(Notation::of(text).written(number), text);
        }
        assert_eq!(Notation::of(" 0X2b").written(43), "0x2B");
        assert_eq!(Notation::of("0x10..=0x1F").written(31), "0x1F");
    }
}
