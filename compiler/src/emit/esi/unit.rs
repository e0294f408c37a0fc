//! `Unit`: what a step of a value is, in the codes of CiA 303-2, which ETG.1004 takes over.
//!
//! A code is a power of ten, and the numbers of a unit above and below the line. What is no power of ten of such a unit has
//! none: increments, or steps of a third of a millimetre. The numbers of CiA 303-2 are those that makers and open tools use:
//! maxon's EPOS4 and Nanotec's drives have 0x00B44700 for revolutions a minute.

use super::element::Element;
use super::literal::Hex;
use crate::model::{Device, Dimension, Entry, Symbol};

/// Units by their numbers.
const METRE: u32 = 0x01;
const SECOND: u32 = 0x03;
const AMPERE: u32 = 0x04;
const NEWTON: u32 = 0x21;
const VOLT: u32 = 0x26;
const DEGREE: u32 = 0x41;
const MINUTE: u32 = 0x47;
const SQUARE_SECOND: u32 = 0x57;
const REVOLUTION: u32 = 0xB4;

/// The unit of an entry on an axis, if it has a code.
pub(super) fn of(device: &Device, entry: &Entry, axis: Option<u8>) -> Option<Element> {
    let unit = device.unit(entry.unit.as_deref()?)?.on(axis)?;
    let symbol = Symbol::find(&unit.symbol)?;
    let (raw, units) = unit.scale.map_or((1, 1), |scale| (scale.raw, scale.units));
    let Coded { above, below, smallest } = coded(symbol)?;
    let step = u128::from(units) * u128::from(symbol.smallest);
    let power = power_of_ten(step, u128::from(raw) * u128::from(smallest))?;
    let [prefix] = power.to_le_bytes();
    Some(Element::leaf("Unit", Hex(u32::from(prefix) << 24 | above << 16 | below << 8)))
}

/// A unit that has a code.
struct Coded {
    above: u32,
    below: u32,
    /// How many of the smallest unit it is, as symbols count them.
    smallest: u64,
}

/// The unit in which values with a symbol are told.
fn coded(symbol: &Symbol) -> Option<Coded> {
    const ONE: u64 = 1_000_000_000;
    let (above, below, smallest) = match (symbol.dimension, symbol.text) {
        (Dimension::Angle, "rev") => (REVOLUTION, 0, symbol.smallest),
        (Dimension::AngularVelocity, "rpm") => (REVOLUTION, MINUTE, symbol.smallest),
        (Dimension::Length, _) => (METRE, 0, ONE),
        (Dimension::Velocity, _) => (METRE, SECOND, ONE),
        (Dimension::Acceleration, _) => (METRE, SQUARE_SECOND, ONE),
        (Dimension::Angle, _) => (DEGREE, 0, ONE),
        (Dimension::AngularVelocity, _) => (DEGREE, SECOND, ONE),
        (Dimension::AngularAcceleration, _) => (DEGREE, SQUARE_SECOND, ONE),
        (Dimension::Force, _) => (NEWTON, 0, ONE),
        (Dimension::Current, _) => (AMPERE, 0, ONE),
        (Dimension::Voltage, _) => (VOLT, 0, ONE),
        (Dimension::Time, _) => (SECOND, 0, ONE),
        (Dimension::Torque | Dimension::Ratio, _) => return None,
    };
    Some(Coded { above, below, smallest })
}

/// The power of ten that a fraction is, if it is one.
fn power_of_ten(mut above: u128, mut below: u128) -> Option<i8> {
    let mut power = 0;
    while above > below {
        (below, power) = (below.checked_mul(10)?, power + 1);
    }
    while above < below {
        (above, power) = (above.checked_mul(10)?, power - 1);
    }
    (above == below).then_some(power)
}

#[cfg(test)]
mod tests {
    use super::power_of_ten;

    #[test]
    fn powers_of_ten_are_found() {
        assert_eq!(power_of_ten(1, 1), Some(0));
        assert_eq!(power_of_ten(1_000, 1), Some(3));
        assert_eq!(power_of_ten(7, 7_000_000), Some(-6));
        for (above, below) in [(1, 3), (3, 1), (25, 10), (1, 1_048_576)] {
            assert_eq!(power_of_ten(above, below), None, "{above}/{below}");
        }
    }
}
