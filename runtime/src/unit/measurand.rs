//! What can be measured.

use super::{AxisUnit, Motion, Quantity, Scale, Unit};

/// What the values of an entry measure, and what their unit is made of: a [`Quantity`]; a [`Motion`] where it depends on
/// the axis; a [`Scale`] for what is the device's own, such as parts of its peak current; or nothing, `()`.
pub trait Measurand {
    /// The unit of the values of a device.
    type Unit<D>: Copy;
}

impl Measurand for () {
    type Unit<D> = ();
}

impl Measurand for Scale {
    type Unit<D> = Self;
}

impl<Q: Quantity> Measurand for Q {
    type Unit<D> = Unit<D, Q>;
}

impl<L: Quantity, R: Quantity> Measurand for Motion<L, R> {
    type Unit<D> = AxisUnit<D, L, R>;
}
