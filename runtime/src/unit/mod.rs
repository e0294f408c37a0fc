//! Raw values to physical ones and back (CiA 402, factor group).
//!
//! A [`Unit`] belongs to a device and knows what it measures: it makes raw numbers of a [`Length`] or an [`Angle`],
//! and of nothing else. A [`Scale`] is the bare ratio, for raw numbers that count something of the device's own. Where the
//! axes of a device differ in what they measure, [`Motion`] holds what linear and what rotary ones have.

mod measurand;
mod motion;
mod quantity;
mod raw;
mod scale;
mod typed;

pub use measurand::Measurand;
pub use motion::{AxisUnit, Motion};
pub use quantity::{
    Acceleration, Angle, AngularAcceleration, AngularVelocity, Current, Force, Length, Quantity, Ratio, Time,
    Torque, Velocity, Voltage,
};
pub use raw::{Raw, Unfit};
pub use scale::Scale;
pub use typed::Unit;
