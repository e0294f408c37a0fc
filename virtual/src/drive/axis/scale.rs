//! How the steps of an axis' quantities hang together.

use devc::model::{AxisUnit, Dimension, Entry, Symbol};

use super::roles::Finder;

/// What a step of a quantity is in steps of the position, in the time that goes with it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scales {
    /// Steps of the position in a second, for a step of the velocity.
    pub(super) velocity: f64,
    /// Steps of the position in a second squared, for a step of the acceleration.
    pub(super) acceleration: f64,
    /// Steps of the position, for a step of what a touch probe has measured.
    pub(super) probe: f64,
}

/// Where the position of an axis is found.
const POSITIONS: [(u16, u8); 3] = [(0x6064, 0), (0x607A, 0), (0x60C1, 0)];

impl Scales {
    /// From the units of the description; 1 where one is the device's own, such as increments, of which nobody says how
    /// many are a millimetre.
    pub(super) fn new(finder: &Finder<'_>) -> Self {
        let step = |places: &[(u16, u8)], kinds: [Dimension; 2]| {
            let mut entries = places.iter().filter_map(|(index, subindex)| finder.entry(*index, *subindex));
            entries.find_map(|entry| step(finder, entry, kinds))
        };
        let place = [Dimension::Length, Dimension::Angle];
        let position = step(&POSITIONS, place);
        let probe = step(&[(0x60BA, 0), (0x60BB, 0), (0x60BC, 0), (0x60BD, 0)], place);
        let velocity = [Dimension::Velocity, Dimension::AngularVelocity];
        let velocity = step(&[(0x60FF, 0), (0x606C, 0), (0x6081, 0)], velocity);
        let acceleration = [Dimension::Acceleration, Dimension::AngularAcceleration];
        let acceleration = step(&[(0x6083, 0), (0x6084, 0)], acceleration);
        let ratio = |of: Option<(f64, bool)>| match (of, position) {
            (Some((of, is_turning)), Some((position, turns))) if is_turning == turns => of / position,
            _ => 1.0,
        };
        Self { velocity: ratio(velocity), acceleration: ratio(acceleration), probe: ratio(probe) }
    }
}

/// The unit of the position of an axis, and how much of it a step is.
pub(super) fn unit(finder: &Finder<'_>) -> Option<(String, f64)> {
    let mut entries = POSITIONS.iter().filter_map(|(index, subindex)| finder.entry(*index, *subindex));
    let unit = entries.find_map(|entry| finder.device.unit(entry.unit.as_deref()?))?;
    let AxisUnit { symbol, scale } = unit.on(Some(finder.axis))?;
    let step = scale.map_or(1.0, |scale| scale.units as f64 / scale.raw as f64);
    (step > 0.0).then(|| (symbol.clone(), step))
}

/// A step of an entry in the smallest unit that devc knows, and whether it turns: if its unit has a known symbol and is of
/// one of these kinds, the first along a line and the second turning.
fn step(finder: &Finder<'_>, entry: &Entry, [line, angle]: [Dimension; 2]) -> Option<(f64, bool)> {
    let unit = finder.device.unit(entry.unit.as_deref()?)?;
    let AxisUnit { symbol, scale } = unit.on(Some(finder.axis))?;
    let (symbol, scale) = (Symbol::find(symbol)?, (*scale)?);
    let is_known = symbol.dimension == line || symbol.dimension == angle;
    let step = symbol.smallest as f64 * scale.units as f64 / scale.raw as f64;
    (is_known && step > 0.0).then_some((step, symbol.dimension == angle))
}
