//! What the symbols of units measure.

use super::names::camel;
use proc_macro2::Ident;

/// A unit that the runtime has a quantity for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Measure {
    /// The runtime's name of the quantity.
    quantity: &'static str,
    /// How many of the quantity's smallest unit it is.
    pub(super) smallest: u64,
}

impl Measure {
    /// What a symbol stands for; none if the unit is the device's own, as increments are.
    pub(super) fn of(symbol: &str) -> Option<Self> {
        let &(_, quantity, smallest) = SYMBOLS.iter().find(|(known, ..)| *known == symbol)?;
        Some(Self { quantity, smallest })
    }

    pub(super) fn quantity(self) -> Ident {
        camel(self.quantity)
    }
}

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
