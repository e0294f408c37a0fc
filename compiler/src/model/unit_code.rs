//! The codes of units: those of CiA 303-2, which ETG.1004 takes over.
//!
//! A code is a power of ten, and the numbers of a unit above and below the line. What is no power of ten of such a unit has
//! none: increments, or steps of a third of a millimetre. The numbers of CiA 303-2 are those that makers and open tools use:
//! maxon's EPOS4 and Nanotec's drives have 0x00B44700 for revolutions a minute.

#![cfg_attr(not(all(feature = "esi", feature = "import")), allow(dead_code))] // each needs a part

use super::{Dimension, SYMBOLS, Symbol};

/// A unit that has a code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct UnitCode {
    /// The symbol of the unit itself, no power of ten of it.
    pub(crate) symbol: &'static str,
    /// What is measured in it.
    pub(crate) quantity: &'static str,
    above: u8,
    below: u8,
}

/// The numbers of units.
const METRE: u8 = 0x01;
const SECOND: u8 = 0x03;
const AMPERE: u8 = 0x04;
const NEWTON: u8 = 0x21;
const VOLT: u8 = 0x26;
const DEGREE: u8 = 0x41;
const MINUTE: u8 = 0x47;
const SQUARE_SECOND: u8 = 0x57;
const REVOLUTION: u8 = 0xB4;

/// Of what one can measure in different units, the usual one comes first.
#[rustfmt::skip] // a line each
const CODES: &[UnitCode] = &[
    code("m", "length", METRE, 0),
    code("m/s", "velocity", METRE, SECOND),
    code("m/s²", "acceleration", METRE, SQUARE_SECOND),
    code("deg", "angle", DEGREE, 0),
    code("deg/s", "angular velocity", DEGREE, SECOND),
    code("deg/s²", "angular acceleration", DEGREE, SQUARE_SECOND),
    code("rev", "angle", REVOLUTION, 0),
    code("rpm", "rotational speed", REVOLUTION, MINUTE),
    code("N", "force", NEWTON, 0),
    code("A", "current", AMPERE, 0),
    code("V", "voltage", VOLT, 0),
    code("s", "time", SECOND, 0),
];

/// The greatest power of ten in 64 bits.
const MOST: u8 = 19;

const fn code(symbol: &'static str, quantity: &'static str, above: u8, below: u8) -> UnitCode {
    UnitCode { symbol, quantity, above, below }
}

impl UnitCode {
    /// The unit that a symbol is a part or a multiple of.
    pub(crate) fn of(symbol: &Symbol) -> Option<&'static Self> {
        let exact = || CODES.iter().find(|code| code.symbol == symbol.text);
        let alike = || CODES.iter().find(|code| code.dimension() == Some(symbol.dimension));
        exact().or_else(alike)
    }

    /// The unit of a code, and the power of ten of it that is meant; none of what no number of 64 bits can scale.
    pub(crate) fn read(code: u32) -> Option<(&'static Self, i8)> {
        let [power, above, below, reserved] = code.to_be_bytes();
        let unit = CODES.iter().find(|it| (it.above, it.below, 0) == (above, below, reserved))?;
        Some((unit, power.cast_signed())).filter(|(_, power)| power.unsigned_abs() <= MOST)
    }

    /// The code of a power of ten of the unit.
    pub(crate) fn number(&self, power: i8) -> u32 {
        u32::from_be_bytes([power.cast_unsigned(), self.above, self.below, 0])
    }

    /// How many of the smallest unit it is, as symbols count them.
    pub(crate) fn smallest(&self) -> Option<u64> {
        Symbol::find(self.symbol).map(|symbol| symbol.smallest)
    }

    /// The symbol of a power of ten of it, if there is one.
    pub(crate) fn symbol_of(&self, power: i8) -> Option<&'static str> {
        let own = || Symbol::find(self.symbol);
        let is_it = |symbol: &&Symbol| {
            let is_alike = Self::of(symbol) == Some(self);
            is_alike && own().is_some_and(|own| is_power(symbol.smallest, own.smallest, power))
        };
        if power == 0 { Some(self.symbol) } else { SYMBOLS.iter().find(is_it).map(|symbol| symbol.text) }
    }

    fn dimension(&self) -> Option<Dimension> {
        Symbol::find(self.symbol).map(|symbol| symbol.dimension)
    }
}

/// Whether a number is another one times a power of ten.
fn is_power(number: u64, other: u64, power: i8) -> bool {
    let factor = 10_u64.checked_pow(power.unsigned_abs().into());
    let (large, small) = if power < 0 { (other, number) } else { (number, other) };
    factor.and_then(|factor| small.checked_mul(factor)) == Some(large)
}

#[cfg(test)]
mod tests {
    use super::{CODES, UnitCode};

    #[test]
    fn codes_of_drives_in_use_are_read() {
        let read = |code| UnitCode::read(code).map(|(unit, power)| (unit.symbol, power));
        // CiA 303-2 in objects 0x60A8 and 0x60A9 of drives: thousandths of a degree, revolutions a minute.
        assert_eq!(read(0xFD41_0000), Some(("deg", -3)));
        assert_eq!(read(0x00B4_4700), Some(("rpm", 0)));
        assert_eq!(read(0x0000_0000), None);
        assert_eq!(read(0x0001_0001), None);
    }

    #[test]
    fn symbols_are_powers_of_ten() {
        let symbol = |code| UnitCode::read(code).and_then(|(unit, power)| unit.symbol_of(power));
        assert_eq!(symbol(0xFD04_0000), Some("mA"));
        assert_eq!(symbol(0xF703_0000), Some("ns"));
        assert_eq!(symbol(0xFA01_0300), Some("µm/s"));
        assert_eq!(symbol(0xFE26_0000), None);
        for code in CODES {
            assert_eq!(UnitCode::read(code.number(-2)), Some((code, -2)));
            assert!(code.smallest().is_some(), "{}", code.symbol);
        }
    }
}
