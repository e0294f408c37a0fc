//! `Unit`: what a step of a value is, as a code. What is no power of ten of a unit that has one has none.

use super::element::Element;
use super::literal::Hex;
use crate::model::{Device, Entry, Symbol, UnitCode};

/// The unit of an entry on an axis, if it has a code.
pub(super) fn of(device: &Device, entry: &Entry, axis: Option<u8>) -> Option<Element> {
    let unit = device.unit(entry.unit.as_deref()?)?.on(axis)?;
    let symbol = Symbol::find(&unit.symbol)?;
    let (raw, units) = unit.scale.map_or((1, 1), |scale| (scale.raw, scale.units));
    let code = UnitCode::of(symbol)?;
    let step = u128::from(units) * u128::from(symbol.smallest);
    let power = power_of_ten(step, u128::from(raw) * u128::from(code.smallest()?))?;
    Some(Element::leaf("Unit", Hex(code.number(power))))
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
