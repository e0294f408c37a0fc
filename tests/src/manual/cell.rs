//! What a cell can hold.

/// A type that one cell is read as.
pub trait Cell: Sized {
    /// Reads the text between two tabs.
    ///
    /// # Errors
    ///
    /// What was expected, and what stands there.
    fn parse(text: &'static str) -> Result<Self, String>;
}

/// Text as it stands.
impl Cell for &'static str {
    fn parse(text: &'static str) -> Result<Self, String> {
        Ok(text)
    }
}

macro_rules! integers {
    ($($type:ty)+) => {$(
        /// Decimal, or hexadecimal after `0x`.
        impl Cell for $type {
            fn parse(text: &'static str) -> Result<Self, String> {
                match text.strip_prefix("0x") {
                    Some(digits) => <$type>::from_str_radix(digits, 16),
                    None => text.parse(),
                }
                .map_err(|fault| format!("`{text}` is no {}: {fault}", stringify!($type)))
            }
        }
    )+};
}
integers!(i8 u8 u16 u32 i64);

/// A mark: `yes`, or `no` or nothing.
impl Cell for bool {
    fn parse(text: &'static str) -> Result<Self, String> {
        match text {
            "yes" => Ok(true),
            "no" | "" => Ok(false),
            other => Err(format!("`{other}` is neither `yes` nor `no`")),
        }
    }
}

/// Nothing, where the manual prints nothing.
impl<T: Cell> Cell for Option<T> {
    fn parse(text: &'static str) -> Result<Self, String> {
        if text.is_empty() { Ok(None) } else { T::parse(text).map(Some) }
    }
}

/// Values with commas between them; none in an empty cell.
impl<T: Cell> Cell for Vec<T> {
    fn parse(text: &'static str) -> Result<Self, String> {
        text.split(',').filter(|part| !part.is_empty()).map(T::parse).collect()
    }
}

/// Declares an enum whose variants are words of a column.
macro_rules! words {
    ($($(#[$meta:meta])* $name:ident { $($(#[$variant_meta:meta])* $variant:ident = $word:literal,)+ })+) => {$(
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum $name { $($(#[$variant_meta])* $variant,)+ }

        impl Cell for $name {
            fn parse(text: &'static str) -> Result<Self, String> {
                match text {
                    $($word => Ok(Self::$variant),)+
                    other => Err(format!("`{other}` is none of {:?}", [$($word),+])),
                }
            }
        }
    )+};
}

words! {
    /// Access of an entry through SDO.
    Access {
        /// Can be read.
        ReadOnly = "RO",
        /// Can be read and written.
        ReadWrite = "RW",
    }
    /// Direction of a PDO, seen from the device.
    Direction {
        /// Master to device: outputs of the master.
        Rx = "Rx",
        /// Device to master: inputs of the master.
        Tx = "Tx",
    }
    /// How many axes must make a transition before the hexapod makes it.
    Axes {
        /// Every axis.
        All = "all",
        /// One axis is enough.
        One = "one",
    }
    /// State of the brake, where there is one.
    Brake {
        /// Closed.
        Applied = "yes",
        /// Open where the drive function needs it.
        Depends = "depends",
    }
    /// What a row of the error table stands for.
    ErrorKind {
        /// The absence of an error.
        None = "none",
        /// One error code.
        Code = "code",
        /// A range that is set aside for errors of the manufacturer.
        Range = "range",
    }
    /// A member of the S700's family.
    Member {
        /// SERVOSTAR 300.
        S300 = "S300",
        /// SERVOSTAR 400.
        S400 = "S400",
        /// SERVOSTAR 600.
        S600 = "S600",
        /// S700.
        S700 = "S700",
    }
    /// What a bit must do or be for a transition.
    Input {
        /// It does not matter.
        Any = "-",
        /// Be 0.
        Low = "0",
        /// Be 1.
        High = "1",
        /// Change from 0 to 1.
        Rising = "P",
        /// Change from 1 to 0.
        Falling = "N",
    }
    /// A change of a bit.
    Edge {
        /// From 0 to 1.
        Rising = "rising",
        /// From 1 to 0.
        Falling = "falling",
    }
    /// A word that has bits.
    Word {
        /// Written by the master.
        Control = "control",
        /// Read by the master.
        Status = "status",
    }
    /// An axis of a double-axis controller.
    AxisLetter {
        /// The first one.
        A = "A",
        /// The second one.
        B = "B",
    }
}

/// Subindex of an entry as the dictionary prints it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Sub {
    /// None: the object is a single variable.
    Variable,
    /// One subindex.
    One(u8),
    /// All subindices from the first to the last, in one row.
    Range(u8, u8),
}

/// Decimal; `01:32` is a range.
impl Cell for Sub {
    fn parse(text: &'static str) -> Result<Self, String> {
        match text.split_once(':') {
            Some((first, last)) => Ok(Self::Range(u8::parse(first)?, u8::parse(last)?)),
            None => Option::<u8>::parse(text).map(|sub| sub.map_or(Self::Variable, Self::One)),
        }
    }
}

/// A pattern of bits, the highest first: `0` and `1` are fixed, `x` is free, `r` must rise from 0 to 1.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Pattern {
    /// The bits that are fixed.
    pub mask: u16,
    /// The fixed bits that are 1.
    pub value: u16,
    /// The bits that must rise.
    pub rising: u16,
}

impl Pattern {
    /// Whether one word can match both patterns, edges left aside.
    #[must_use]
    pub fn overlaps(self, other: Self) -> bool {
        let both = self.mask & other.mask;
        self.value & both == other.value & both
    }
}

impl Cell for Pattern {
    fn parse(text: &'static str) -> Result<Self, String> {
        text.chars().filter(|bit| *bit != ' ').try_fold(Self::default(), |high, bit| {
            let (mask, value, rising) = match bit {
                '0' => (1, 0, 0),
                '1' => (1, 1, 0),
                'x' => (0, 0, 0),
                'r' => (0, 0, 1),
                other => return Err(format!("`{other}` is no bit of the pattern `{text}`")),
            };
            Ok(Self {
                mask: high.mask << 1 | mask,
                value: high.value << 1 | value,
                rising: high.rising << 1 | rising,
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_that_hold_something_else_are_refused() {
        assert_eq!(Sub::parse("01:32"), Ok(Sub::Range(1, 32)));
        assert_eq!(Pattern::parse("r01x"), Ok(Pattern { mask: 0b0110, value: 0b0010, rising: 0b1000 }));
        assert!(u8::parse("0x100").is_err());
        assert!(bool::parse("maybe").is_err());
        assert!(Access::parse("WO").is_err());
        assert!(Sub::parse("01:").is_err());
        assert!(Pattern::parse("0120").is_err());
        assert!(Vec::<u8>::parse("1,b").is_err());
    }
}
