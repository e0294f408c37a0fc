//! What the symbols of units measure.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

use super::names::camel;
use crate::model::{AxisUnit, Scale};

/// What raw numbers stand for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Means {
    /// Something of the device's own, as increments are.
    Own,
    /// A quantity of the runtime, by its name.
    Quantity(&'static str),
    /// A quantity on linear axes, and another on rotary ones.
    Motion(&'static str, &'static str),
}

impl Means {
    /// What a unit stands for, and how many raw steps make how many of the quantity's smallest unit, or of the device's
    /// own; none if these numbers are beyond those of a scale.
    pub(super) fn of(unit: &AxisUnit) -> Option<(Self, Scale)> {
        let (units, raw) = unit.scale.map_or((1, 1), |scale| (scale.units, scale.raw));
        let (means, smallest) = match SYMBOLS.iter().find(|(known, ..)| *known == unit.symbol) {
            Some((_, quantity, smallest)) => (Self::Quantity(quantity), units.checked_mul(*smallest)?),
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
        let (linear, rotary) = MOTIONS.iter().find(|(linear, rotary)| is_one(linear, rotary))?;
        Some(Self::Motion(linear, rotary))
    }

    /// The runtime's type of what is measured.
    pub(super) fn measurand(self) -> TokenStream {
        match self {
            Self::Own => quote!(Scale),
            Self::Quantity(quantity) => camel(quantity).into_token_stream(),
            Self::Motion(linear, rotary) => {
                let (linear, rotary) = (camel(linear), camel(rotary));
                quote!(Motion<#linear, #rotary>)
            }
        }
    }

    /// The runtime's type of such a unit of a device.
    pub(super) fn unit(self, marker: &Ident) -> TokenStream {
        match self {
            Self::Own => quote!(Scale),
            Self::Quantity(quantity) => {
                let quantity = camel(quantity);
                quote!(Unit<#marker, #quantity>)
            }
            Self::Motion(linear, rotary) => {
                let (linear, rotary) = (camel(linear), camel(rotary));
                quote!(AxisUnit<#marker, #linear, #rotary>)
            }
        }
    }

    /// The names in these types that are the runtime's.
    pub(super) fn imports(self) -> Vec<&'static str> {
        match self {
            Self::Own => vec!["Scale"],
            Self::Quantity(quantity) => vec!["Unit", quantity],
            Self::Motion(..) => vec!["AxisUnit", "Motion"],
        }
    }

    /// Whether it is what rotary axes have.
    pub(super) fn is_rotary(self) -> bool {
        MOTIONS.iter().any(|(_, rotary)| self == Self::Quantity(rotary))
    }
}

/// What linear axes have, and what rotary ones have for it.
const MOTIONS: &[(&str, &str)] = &[
    ("Length", "Angle"),
    ("Velocity", "AngularVelocity"),
    ("Acceleration", "AngularAcceleration"),
    ("Force", "Torque"),
];

/// The symbols with their quantities, and how many of a quantity's smallest unit each is.
const SYMBOLS: &[(&str, &str, u64)] = &[
    ("nm", "Length", 1),
    ("µm", "Length", 1_000),
    ("mm", "Length", 1_000_000),
    ("m", "Length", 1_000_000_000),
    ("mdeg", "Angle", 1_000_000),
    ("deg", "Angle", 1_000_000_000),
    ("°", "Angle", 1_000_000_000),
    ("rev", "Angle", 360_000_000_000),
    ("µm/s", "Velocity", 1_000),
    ("mm/s", "Velocity", 1_000_000),
    ("m/s", "Velocity", 1_000_000_000),
    ("mdeg/s", "AngularVelocity", 1_000_000),
    ("deg/s", "AngularVelocity", 1_000_000_000),
    ("°/s", "AngularVelocity", 1_000_000_000),
    ("rpm", "AngularVelocity", 6_000_000_000),
    ("µm/s²", "Acceleration", 1_000),
    ("mm/s²", "Acceleration", 1_000_000),
    ("m/s²", "Acceleration", 1_000_000_000),
    ("mdeg/s²", "AngularAcceleration", 1_000_000),
    ("deg/s²", "AngularAcceleration", 1_000_000_000),
    ("°/s²", "AngularAcceleration", 1_000_000_000),
    ("mN", "Force", 1_000_000),
    ("N", "Force", 1_000_000_000),
    ("mNm", "Torque", 1_000_000),
    ("Nm", "Torque", 1_000_000_000),
    ("mA", "Current", 1_000_000),
    ("A", "Current", 1_000_000_000),
    ("mV", "Voltage", 1_000_000),
    ("V", "Voltage", 1_000_000_000),
    ("ns", "Time", 1),
    ("µs", "Time", 1_000),
    ("ms", "Time", 1_000_000),
    ("s", "Time", 1_000_000_000),
    ("‰", "Ratio", 1_000_000),
    ("%", "Ratio", 10_000_000),
];
