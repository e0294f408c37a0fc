//! What the symbols of units measure.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

use super::names::camel;
use crate::model::{AxisUnit, Dimension, Scale, Symbol};

/// What raw numbers stand for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Means {
    /// Something of the device's own, as increments are.
    Own,
    /// A quantity of the runtime, by its name.
    Quantity(Dimension),
    /// A quantity on linear axes, and another on rotary ones.
    Motion(Dimension, Dimension),
}

impl Means {
    /// What a unit stands for, and how many raw steps make how many of the quantity's smallest unit, or of the device's
    /// own; none if these numbers are beyond those of a scale.
    pub(super) fn of(unit: &AxisUnit) -> Option<(Self, Scale)> {
        let (units, raw) = unit.scale.map_or((1, 1), |scale| (scale.units, scale.raw));
        let (means, smallest) = match Symbol::find(&unit.symbol) {
            Some(symbol) => (Self::Quantity(symbol.dimension), units.checked_mul(symbol.smallest)?),
            None => (Self::Own, units),
        };
        (smallest > 0 && raw > 0).then(|| (means, Scale::lowest(raw, smallest)))
    }

    /// What several axes have in common; none if no type of the runtime holds it.
    pub(super) fn of_axes(axes: &[Self]) -> Option<Self> {
        let first = *axes.first()?;
        if axes.iter().all(|means| *means == first) {
            return Some(first);
        }
        let is_one =
            |linear, rotary| axes.iter().all(|means| [linear, rotary].map(Self::Quantity).contains(means));
        let (linear, rotary) = MOTIONS.iter().find(|(linear, rotary)| is_one(*linear, *rotary))?;
        Some(Self::Motion(*linear, *rotary))
    }

    /// The runtime's type of what is measured.
    pub(super) fn measurand(self) -> TokenStream {
        match self {
            Self::Own => quote!(Scale),
            Self::Quantity(quantity) => camel(name(quantity)).into_token_stream(),
            Self::Motion(linear, rotary) => {
                let (linear, rotary) = (camel(name(linear)), camel(name(rotary)));
                quote!(Motion<#linear, #rotary>)
            }
        }
    }

    /// The runtime's type of such a unit of a device.
    pub(super) fn unit(self, marker: &Ident) -> TokenStream {
        match self {
            Self::Own => quote!(Scale),
            Self::Quantity(quantity) => {
                let quantity = camel(name(quantity));
                quote!(Unit<#marker, #quantity>)
            }
            Self::Motion(linear, rotary) => {
                let (linear, rotary) = (camel(name(linear)), camel(name(rotary)));
                quote!(AxisUnit<#marker, #linear, #rotary>)
            }
        }
    }

    /// The names in these types that are the runtime's.
    pub(super) fn imports(self) -> Vec<&'static str> {
        match self {
            Self::Own => vec!["Scale"],
            Self::Quantity(quantity) => vec!["Unit", name(quantity)],
            Self::Motion(..) => vec!["AxisUnit", "Motion"],
        }
    }

    /// Whether it is what rotary axes have.
    pub(super) fn is_rotary(self) -> bool {
        MOTIONS.iter().any(|(_, rotary)| self == Self::Quantity(*rotary))
    }
}

/// What linear axes have, and what rotary ones have for it.
const MOTIONS: &[(Dimension, Dimension)] = &[
    (Dimension::Length, Dimension::Angle),
    (Dimension::Velocity, Dimension::AngularVelocity),
    (Dimension::Acceleration, Dimension::AngularAcceleration),
    (Dimension::Force, Dimension::Torque),
];

/// The runtime's type for it.
fn name(dimension: Dimension) -> &'static str {
    match dimension {
        Dimension::Length => "Length",
        Dimension::Angle => "Angle",
        Dimension::Velocity => "Velocity",
        Dimension::AngularVelocity => "AngularVelocity",
        Dimension::Acceleration => "Acceleration",
        Dimension::AngularAcceleration => "AngularAcceleration",
        Dimension::Force => "Force",
        Dimension::Torque => "Torque",
        Dimension::Current => "Current",
        Dimension::Voltage => "Voltage",
        Dimension::Time => "Time",
        Dimension::Ratio => "Ratio",
    }
}
