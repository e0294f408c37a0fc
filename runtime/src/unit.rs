//! Raw values to physical ones and back (CiA 402, factor group).

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
    numerator: NonZero<u32>,
    denominator: NonZero<u32>,
}

impl Scale {
    /// A scale that the description states.
    pub const fn of<const NUMERATOR: u32, const DENOMINATOR: u32>() -> Self {
        const { Self::new(NUMERATOR, DENOMINATOR).expect("numerator and denominator of a scale are not 0") }
    }

    /// A scale read from a device, as from the position factor 0x6093; `None` if either number is 0.
    pub const fn new(numerator: u32, denominator: u32) -> Option<Self> {
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
        f64::from(raw) * f64::from(self.numerator.get()) / f64::from(self.denominator.get())
    }
}

/// value × multiplier ÷ divisor, if nothing is left over and it fits.
fn exact(value: i64, multiplier: NonZero<u32>, divisor: NonZero<u32>) -> Option<i64> {
    let (product, divisor) = magnitudes(value, multiplier, divisor);
    if product % divisor == 0 { signed(product / divisor, value) } else { None }
}

/// value × multiplier ÷ divisor to the nearest, or the end of the range.
fn rounded(value: i64, multiplier: NonZero<u32>, divisor: NonZero<u32>) -> i64 {
    let (product, divisor) = magnitudes(value, multiplier, divisor);
    let rest = product % divisor;
    let up = u128::from(rest != 0 && rest >= divisor.get().saturating_sub(rest));
    let nearest = (product / divisor).saturating_add(up);
    signed(nearest, value).unwrap_or(if value < 0 { i64::MIN } else { i64::MAX })
}

/// |value| × multiplier cannot overflow: 64 and 32 bits make at most 96.
fn magnitudes(value: i64, multiplier: NonZero<u32>, divisor: NonZero<u32>) -> (u128, NonZero<u128>) {
    let product = u128::from(value.unsigned_abs()).saturating_mul(u128::from(multiplier.get()));
    (product, NonZero::from(divisor))
}

/// The magnitude with the sign of `like`, if it fits.
fn signed(magnitude: u128, like: i64) -> Option<i64> {
    let magnitude = i128::try_from(magnitude).ok()?;
    i64::try_from(if like < 0 { magnitude.checked_neg()? } else { magnitude }).ok()
}
