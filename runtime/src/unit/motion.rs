//! Axes that move along a line, and axes that turn.

use core::fmt;

use super::{Quantity, Raw, Unit};

/// What an axis has, depending on how it moves (CiA 402, linear and rotary motors): a length or an angle, a force or a
/// torque, or the unit of either. To come to it, one has to say what is done in both cases.
///
/// ```
/// use devc_runtime::unit::{Angle, Length, Motion};
///
/// let position: Motion<Length, Angle> = Motion::Linear(Length::micrometres(1500));
/// let is_far = match position {
///     Motion::Linear(length) => length > Length::millimetres(1),
///     Motion::Rotary(angle) => angle > Angle::degrees(1),
/// };
/// assert!(is_far);
/// assert_eq!(position.to_string(), "0.0015 m");
/// ```
///
/// It is not taken for one of them:
///
/// ```compile_fail,E0308
/// # use devc_runtime::unit::{Angle, Length, Motion};
/// # let position: Motion<Length, Angle> = Motion::Linear(Length::micrometres(1500));
/// let length: Length = position;
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Motion<L, R> {
    /// Along a line.
    Linear(L),
    /// Round an axis.
    Rotary(R),
}

/// The unit of an axis of device `D`: of the quantity `L` if it is linear, of `R` if it is rotary.
pub type AxisUnit<D, L, R> = Motion<Unit<D, L>, Unit<D, R>>;

impl<D, L: Quantity, R: Quantity> AxisUnit<D, L, R> {
    /// What a raw number means, to the quantity's smallest unit; at the end of its range if it is beyond it.
    pub fn physical<N: Raw>(self, raw: N) -> Motion<L, R> {
        match self {
            Self::Linear(unit) => Motion::Linear(unit.physical(raw)),
            Self::Rotary(unit) => Motion::Rotary(unit.physical(raw)),
        }
    }
}

impl<L: fmt::Display, R: fmt::Display> fmt::Display for Motion<L, R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Linear(value) => value.fmt(f),
            Self::Rotary(value) => value.fmt(f),
        }
    }
}
