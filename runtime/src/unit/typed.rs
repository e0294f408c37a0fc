//! Units of a device.

use core::fmt;
use core::marker::PhantomData;

use super::{Quantity, Raw, Scale, Unfit};

/// What raw numbers of device `D` mean: so much of the quantity `Q`. One for each way a value travels, since drives
/// scale process data and SDOs differently (C887T0011, p. 14).
///
/// Each conversion says what it does with a value that is no whole raw number or does not fit; none wraps. Which integer
/// type the number has is up to where it goes.
///
/// ```
/// use devc_runtime::unit::{Length, Unfit, Unit};
///
/// enum C887 {}
/// /// Position in process data: 1/100 000 mm, which is 10 nm.
/// const POSITION_MM: Unit<C887, Length> = Unit::of::<10, 1>();
///
/// let target: i32 = POSITION_MM.exact(Length::micrometres(15))?;
/// assert_eq!(target, 1500);
/// assert_eq!(POSITION_MM.physical(target), Length::micrometres(15));
///
/// // 15 nm lies between two numbers, and 30 m are beyond an `i32`
/// assert_eq!(POSITION_MM.exact::<i32>(Length::nanometres(15)), Err(Unfit::Inexact));
/// assert_eq!(POSITION_MM.nearest::<i32>(Length::nanometres(15)), Ok(2));
/// assert_eq!(POSITION_MM.nearest::<i32>(Length::metres(30)), Err(Unfit::OutOfRange));
/// assert_eq!(POSITION_MM.saturating::<i32>(Length::metres(30)), i32::MAX);
/// # Ok::<(), Unfit>(())
/// ```
///
/// What measures something else does not compile:
///
/// ```compile_fail,E0308
/// # use devc_runtime::unit::{Angle, Length, Unit};
/// # enum C887 {}
/// # const POSITION_MM: Unit<C887, Length> = Unit::of::<10, 1>();
/// let target: i32 = POSITION_MM.saturating(Angle::degrees(15));
/// ```
pub struct Unit<D, Q> {
    scale: Scale,
    checked: PhantomData<(D, Q)>,
}

impl<D, Q> Unit<D, Q> {
    /// The unit in which `RAW` steps are `SMALLEST` of the quantity's smallest unit. Neither may be 0.
    pub const fn of<const SMALLEST: u64, const RAW: u64>() -> Self {
        Self { scale: Scale::of::<SMALLEST, RAW>(), checked: PhantomData }
    }

    /// The ratio of the quantity's smallest unit to a raw step.
    pub const fn scale(self) -> Scale {
        self.scale
    }
}

impl<D, Q: Quantity> Unit<D, Q> {
    /// The raw number, if there is one that is just it.
    pub fn exact<R: Raw>(self, value: Q) -> Result<R, Unfit> {
        let number = self.scale.raw(value.smallest());
        // one that only does not fit is not between two
        let number = number.ok_or_else(|| self.nearest::<R>(value).err().unwrap_or(Unfit::Inexact))?;
        R::narrow(number).ok_or(Unfit::OutOfRange)
    }

    /// The nearest raw number, halves away from 0, if the type holds it.
    pub fn nearest<R: Raw>(self, value: Q) -> Result<R, Unfit> {
        let number = self.scale.raw_rounded(value.smallest());
        let is_end = number == i64::MAX || number == i64::MIN;
        R::narrow(number).filter(|_| !is_end).ok_or(Unfit::OutOfRange)
    }

    /// The nearest raw number that the type holds.
    pub fn saturating<R: Raw>(self, value: Q) -> R {
        R::saturate(self.scale.raw_rounded(value.smallest()))
    }

    /// What a raw number means, to the quantity's smallest unit; at the end of its range if it is beyond it.
    pub fn physical<R: Raw>(self, raw: R) -> Q {
        Q::from_smallest(self.scale.physical_rounded(raw.widen()))
    }

    /// What a raw number means, if that is a whole number of the quantity's smallest unit.
    pub fn physical_exact<R: Raw>(self, raw: R) -> Result<Q, Unfit> {
        self.scale.physical(raw.widen()).map(Q::from_smallest).ok_or(Unfit::Inexact)
    }
}

impl<D, Q> Clone for Unit<D, Q> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<D, Q> Copy for Unit<D, Q> {}

impl<D, Q> PartialEq for Unit<D, Q> {
    fn eq(&self, other: &Self) -> bool {
        self.scale == other.scale
    }
}

impl<D, Q> Eq for Unit<D, Q> {}

impl<D, Q> fmt::Debug for Unit<D, Q> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Unit({:?})", self.scale)
    }
}
