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
