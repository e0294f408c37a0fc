//! Entries whose values measure something.

use super::Entry;
use crate::unit::{Motion, Quantity, Raw, Unfit};

/// The value of a quantity in the type of the entry, for SDOs and for the fields of process data alike.
///
/// Each conversion says what it does with a quantity that is no whole raw number or does not fit; none wraps.
///
/// ```
/// use devc_runtime::object::{Entry, ReadWrite};
/// use devc_runtime::pdo::Unmapped;
/// use devc_runtime::unit::{Length, Unfit, Unit};
///
/// enum C887 {}
/// /// In micrometres.
/// const AXIS_X: Entry<C887, i32, ReadWrite, Unmapped, Length> =
///     Entry::new(0x5000, 1).measured_in(Unit::of::<1000, 1>());
///
/// let origin = AXIS_X.exact(Length::millimetres(15))?;
/// assert_eq!(AXIS_X.encode(origin), 15_000_i32.to_le_bytes());
/// assert_eq!(AXIS_X.physical(origin), Length::millimetres(15));
///
/// // 1.5 µm lie between two numbers, and 3 km are beyond an `i32`
/// assert_eq!(AXIS_X.exact(Length::nanometres(1500)), Err(Unfit::Inexact));
/// assert_eq!(AXIS_X.nearest(Length::nanometres(1500)), Ok(2));
/// assert_eq!(AXIS_X.nearest(Length::metres(3000)), Err(Unfit::OutOfRange));
/// assert_eq!(AXIS_X.saturating(Length::metres(3000)), i32::MAX);
/// # Ok::<(), Unfit>(())
/// ```
///
/// What measures something else does not compile:
///
/// ```compile_fail,E0308
/// # use devc_runtime::object::{Entry, ReadWrite};
/// # use devc_runtime::pdo::Unmapped;
/// # use devc_runtime::unit::{Angle, Length, Unit};
/// # enum C887 {}
/// # const AXIS_X: Entry<C887, i32, ReadWrite, Unmapped, Length> =
/// #     Entry::new(0x5000, 1).measured_in(Unit::of::<1000, 1>());
/// AXIS_X.saturating(Angle::degrees(15));
/// ```
///
/// Nor a quantity for an entry that measures nothing:
///
/// ```compile_fail,E0599
/// # use devc_runtime::object::{Entry, ReadWrite};
/// # use devc_runtime::unit::Length;
/// # enum C887 {}
/// # const CONTROLWORD: Entry<C887, u16, ReadWrite> = Entry::new(0x6040, 0);
/// CONTROLWORD.saturating(Length::millimetres(15));
/// ```
impl<D, T: Raw, A, M, Q: Quantity> Entry<D, T, A, M, Q> {
    /// The value that is just the quantity, if there is one.
    pub fn exact(self, quantity: Q) -> Result<T, Unfit> {
        self.unit().exact(quantity)
    }

    /// The value nearest to the quantity, halves away from 0, if the type holds it.
    pub fn nearest(self, quantity: Q) -> Result<T, Unfit> {
        self.unit().nearest(quantity)
    }

    /// The nearest value that the type holds.
    pub fn saturating(self, quantity: Q) -> T {
        self.unit().saturating(quantity)
    }

    /// What a value means, to the quantity's smallest unit; at the end of its range if it is beyond it.
    pub fn physical(self, value: T) -> Q {
        self.unit().physical(value)
    }
}

/// What a value means on an axis that may be linear or rotary. For the way back, the [`unit`](Entry::unit) is matched:
/// on it depends which quantity there can be.
///
/// ```
/// use devc_runtime::object::{Entry, ReadWrite};
/// use devc_runtime::pdo::Rx;
/// use devc_runtime::unit::{Angle, Length, Motion, Unfit, Unit};
///
/// enum C887 {}
/// type Position = Entry<C887, i32, ReadWrite, Rx, Motion<Length, Angle>>;
///
/// fn outwards(target: Position) -> Result<i32, Unfit> {
///     match target.unit() {
///         Motion::Linear(unit) => unit.exact(Length::micrometres(15)),
///         Motion::Rotary(unit) => unit.exact(Angle::degrees(-2)),
///     }
/// }
///
/// let x: Position = Entry::new(0x607A, 0).measured_in(Motion::Linear(Unit::of::<10, 1>()));
/// assert_eq!(outwards(x), Ok(1500));
/// assert_eq!(x.physical(1500), Motion::Linear(Length::micrometres(15)));
///
/// let u: Position = Entry::new(0x807A, 0).measured_in(Motion::Rotary(Unit::of::<10_000, 1>()));
/// assert_eq!(outwards(u), Ok(-200_000));
/// assert_eq!(u.physical(-200_000).to_string(), "-2 °");
/// ```
impl<D, T: Raw, A, M, L: Quantity, R: Quantity> Entry<D, T, A, M, Motion<L, R>> {
    /// What a value means, to the quantity's smallest unit; at the end of its range if it is beyond it.
    pub fn physical(self, value: T) -> Motion<L, R> {
        self.unit().physical(value)
    }
}
