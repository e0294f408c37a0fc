//! A ratio of whole numbers.

use core::num::NonZero;

/// A scale: physical = raw × numerator ÷ denominator.
///
/// All calculation is exact; what happens when a result is no whole number or does not fit is the caller's choice,
/// and nothing ever wraps. Ask for finer physical units by a scale that has them: a position in 1/100 000 mm is
/// `Scale::of::<1, 100_000>()` in millimetres and `Scale::of::<1, 100>()` in micrometres.
///
/// ```
/// use devc_runtime::unit::Scale;
///
/// const MICROMETRES: Scale = Scale::of::<1, 100>();
///
/// assert_eq!(MICROMETRES.raw(15), Some(1500));
/// assert_eq!(MICROMETRES.physical(1500), Some(15));
/// assert_eq!(MICROMETRES.physical(1501), None);
/// assert_eq!(MICROMETRES.physical_rounded(1550), 16);
/// assert_eq!(MICROMETRES.raw_rounded(i64::MAX), i64::MAX);
/// ```
///
/// A scale of nothing does not compile:
///
/// ```compile_fail,E0080
/// let nothing = devc_runtime::unit::Scale::of::<1, 0>();
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Scale {
    numerator: NonZero<u64>,
    denominator: NonZero<u64>,
}

impl Scale {
    /// A scale that the description states.
    pub const fn of<const NUMERATOR: u64, const DENOMINATOR: u64>() -> Self {
        const { Self::new(NUMERATOR, DENOMINATOR).expect("numerator and denominator of a scale are not 0") }
    }

    /// A scale read from a device, as from the position factor 0x6093; `None` if either number is 0.
    pub const fn new(numerator: u64, denominator: u64) -> Option<Self> {
        match (NonZero::new(numerator), NonZero::new(denominator)) {
            (Some(numerator), Some(denominator)) => Some(Self { numerator, denominator }),
            _ => None,
        }
    }

    /// The physical value, if it is a whole number that fits.
    pub fn physical(self, raw: i64) -> Option<i64> {
        exact(raw, self.numerator, self.denominator)
    }

    /// The nearest whole physical value, halves away from 0; at the end of the range if it does not fit.
    pub fn physical_rounded(self, raw: i64) -> i64 {
        rounded(raw, self.numerator, self.denominator)
    }

    /// The raw value, if it is a whole number that fits.
    pub fn raw(self, physical: i64) -> Option<i64> {
        exact(physical, self.denominator, self.numerator)
    }

    /// The nearest raw value, halves away from 0; at the end of the range if it does not fit. For the range of a
    /// smaller type or of an entry, [`clamp`](Ord::clamp) the result.
    pub fn raw_rounded(self, physical: i64) -> i64 {
        rounded(physical, self.denominator, self.numerator)
    }

    /// The physical value with its fraction, as near as `f64` comes.
    pub fn physical_f64(self, raw: i32) -> f64 {
        f64::from(raw) * self.numerator.get() as f64 / self.denominator.get() as f64
    }
}

/// value × multiplier ÷ divisor, if nothing is left over and it fits.
fn exact(value: i64, multiplier: NonZero<u64>, divisor: NonZero<u64>) -> Option<i64> {
    let (quotient, rest) = divided(value, multiplier, divisor);
    if rest == 0 { signed(quotient, value) } else { None }
}

/// value × multiplier ÷ divisor to the nearest, or the end of the range.
fn rounded(value: i64, multiplier: NonZero<u64>, divisor: NonZero<u64>) -> i64 {
    let (quotient, rest) = divided(value, multiplier, divisor);
    let is_up = rest != 0 && rest >= divisor.get().saturating_sub(rest);
    let nearest = quotient.saturating_add(u128::from(is_up));
    signed(nearest, value).unwrap_or(if value < 0 { i64::MIN } else { i64::MAX })
}

/// |value| × multiplier ÷ divisor and what is left over. The product cannot overflow: 64 and 64 bits make at most 128.
fn divided(value: i64, multiplier: NonZero<u64>, divisor: NonZero<u64>) -> (u128, u64) {
    let product = u128::from(value.unsigned_abs()).saturating_mul(u128::from(multiplier.get()));
    match u64::try_from(product) {
        // nearly always, and a division of 64 bits is many times faster than one of 128
        Ok(product) => (u128::from(product / divisor), product % divisor),
        Err(_) => {
            let wide = NonZero::from(divisor);
            // a rest is smaller than its divisor
            (product / wide, u64::try_from(product % wide).unwrap_or(0))
        }
    }
}

/// The magnitude with the sign of `like`, if it fits.
fn signed(magnitude: u128, like: i64) -> Option<i64> {
    let magnitude = i128::try_from(magnitude).ok()?;
    i64::try_from(if like < 0 { magnitude.checked_neg()? } else { magnitude }).ok()
}
