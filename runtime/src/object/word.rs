//! Words of bits, for people.

use core::fmt;

/// A bit of a word, or some that are one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BitField {
    /// The lowest bit.
    pub low: u8,
    /// How many bits it has.
    pub bits: u8,
    /// Whether it is part of the state that the word shows.
    pub is_of_state: bool,
    /// Its name.
    pub name: &'static str,
}

impl BitField {
    /// A field; for generated code.
    pub const fn new(low: u8, bits: u8, name: &'static str) -> Self {
        Self { low, bits, is_of_state: false, name }
    }

    /// The same as a part of the state.
    #[must_use]
    pub const fn of_state(self) -> Self {
        Self { is_of_state: true, ..self }
    }

    fn value(self, word: u64) -> u64 {
        let above = 64_u32.saturating_sub(self.bits.into());
        word.checked_shr(self.low.into()).unwrap_or(0) & u64::MAX.checked_shr(above).unwrap_or(0)
    }
}

/// Writes what is set in a word: the state if it shows one that is known, else the bits of it, and then the others. Of more
/// bits than one the number stands behind the name.
///
/// ```
/// use core::fmt;
/// use devc_runtime::object::{BitField, show_word};
///
/// struct Status(u16);
///
/// impl fmt::Display for Status {
///     fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
///         let fields = [
///             BitField::new(2, 1, "operation enabled").of_state(),
///             BitField::new(4, 1, "voltage enabled"),
///             BitField::new(10, 1, "target reached"),
///             BitField::new(12, 3, "gear"),
///         ];
///         let state = (self.0 & 4 != 0).then_some("operation enabled");
///         show_word(f, self.0.into(), state, &fields)
///     }
/// }
///
/// assert_eq!(Status(0x0414).to_string(), "operation enabled, voltage enabled, target reached");
/// assert_eq!(Status(0x5000).to_string(), "gear 5");
/// assert_eq!(Status(0).to_string(), "nothing set");
/// ```
pub fn show_word(
    f: &mut fmt::Formatter<'_>,
    word: u64,
    state: Option<impl fmt::Display>,
    fields: &[BitField],
) -> fmt::Result {
    let mut is_first = true;
    if let Some(state) = &state {
        write!(f, "{state}")?;
        is_first = false;
    }
    for field in fields.iter().filter(|field| state.is_none() || !field.is_of_state) {
        let value = field.value(word);
        if value == 0 {
            continue;
        }
        if !is_first {
            f.write_str(", ")?;
        }
        is_first = false;
        f.write_str(field.name)?;
        if field.bits > 1 {
            write!(f, " {value}")?;
        }
    }
    if is_first { f.write_str("nothing set") } else { Ok(()) }
}

/// Gives a word of bits, a struct around a number, a method for each of its fields: to read it, and to write it if the
/// word is written; then the bit, or the first and the last.
///
/// ```
/// #[derive(Debug, Clone, Copy, PartialEq)]
/// struct Word(u16);
///
/// devc_runtime::bits! {
///     Word: u16;
///     /// Bit 3: on.
///     on, with_on: 3;
///     /// Bits 4 to 6: the phase.
///     phase, with_phase: 4 to 6;
///     /// Bit 15: shown.
///     shown: 15;
/// }
///
/// let word = Word(0x8000).with_on(true).with_phase(9);
/// assert_eq!((word, word.on(), word.phase(), word.shown()), (Word(0x8018), true, 1, true));
/// ```
#[macro_export]
macro_rules! bits {
    ($word:ident: $number:ty; $($(#[$doc:meta])* $get:ident $(, $set:ident)?: $low:literal $(to $high:literal)?;)*) => {
        impl $word {
            $($crate::bits!(@get $number, $(#[$doc])* $get: $low $(to $high)?);)*
            $($crate::bits!(@set $number, [$($set)?] $low $(to $high)?);)*
        }
    };
    (@get $number:ty, $(#[$doc:meta])* $get:ident: $low:literal) => {
        $(#[$doc])*
        pub const fn $get(self) -> bool {
            self.0 & 1 << $low != 0
        }
    };
    (@get $number:ty, $(#[$doc:meta])* $get:ident: $low:literal to $high:literal) => {
        $(#[$doc])*
        pub const fn $get(self) -> $number {
            self.0 >> $low & <$number>::MAX >> (<$number>::BITS - 1 + $low - $high)
        }
    };
    (@set $number:ty, [] $low:literal $(to $high:literal)?) => {};
    (@set $number:ty, [$set:ident] $low:literal) => {
        #[doc = ::core::concat!("The word with bit ", $low, " as given.")]
        #[must_use]
        pub const fn $set(self, on: bool) -> Self {
            Self(self.0 & !(1 << $low) | (on as $number) << $low)
        }
    };
    (@set $number:ty, [$set:ident] $low:literal to $high:literal) => {
        #[doc = ::core::concat!("The word with bits ", $low, " to ", $high, " as given.")]
        #[must_use]
        pub const fn $set(self, value: $number) -> Self {
            let mask: $number = <$number>::MAX >> (<$number>::BITS - 1 + $low - $high);
            Self(self.0 & !(mask << $low) | (value & mask) << $low)
        }
    };
}
