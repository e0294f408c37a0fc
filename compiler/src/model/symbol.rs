//! The symbols of units, what they measure, and the quantities that people write.

use crate::text::near::meant;

/// A kind of physical quantity: symbols of the same kind can be converted into each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// A length or a position on a line.
    Length,
    /// An angle.
    Angle,
    /// A velocity along a line.
    Velocity,
    /// A velocity of turning.
    AngularVelocity,
    /// An acceleration along a line.
    Acceleration,
    /// An acceleration of turning.
    AngularAcceleration,
    /// A force.
    Force,
    /// A torque.
    Torque,
    /// A current.
    Current,
    /// A voltage.
    Voltage,
    /// A time.
    Time,
    /// A part of something: of what, the quantity says.
    Ratio,
}

/// A symbol of a unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Symbol {
    /// As it is written.
    pub text: &'static str,
    /// What it measures.
    pub dimension: Dimension,
    /// How many of the smallest unit that the runtime knows it is: nanometres, billionths of a degree and so on.
    pub smallest: u64,
}

impl Symbol {
    /// The symbol that is written so; none if it is the device's own, as increments are.
    pub fn find(text: &str) -> Option<&'static Self> {
        SYMBOLS.iter().find(|symbol| symbol.text == text)
    }
}

impl Dimension {
    /// The known quantity that is plainly meant by a word with a slip.
    pub(crate) fn quantity_meant(wrong: &str) -> Option<&'static str> {
        let words = QUANTITIES.iter().flat_map(|(words, _)| words.iter().copied());
        meant(wrong, words).and_then(|(word, is_plain)| is_plain.then_some(word))
    }
}

/// What a quantity can be, by the words that people use for it; none for what is not known here.
pub fn dimensions(quantity: &str) -> Option<&'static [Dimension]> {
    let known = QUANTITIES.iter().find(|(words, _)| words.contains(&quantity));
    known.map(|(_, dimensions)| *dimensions)
}

const fn symbol(text: &'static str, dimension: Dimension, smallest: u64) -> Symbol {
    Symbol { text, dimension, smallest }
}

/// All symbols with a meaning.
#[rustfmt::skip] // a line each
pub const SYMBOLS: &[Symbol] = &[
    symbol("nm", Dimension::Length, 1),
    symbol("µm", Dimension::Length, 1_000),
    symbol("mm", Dimension::Length, 1_000_000),
    symbol("m", Dimension::Length, 1_000_000_000),
    symbol("mdeg", Dimension::Angle, 1_000_000),
    symbol("deg", Dimension::Angle, 1_000_000_000),
    symbol("°", Dimension::Angle, 1_000_000_000),
    symbol("rev", Dimension::Angle, 360_000_000_000),
    symbol("µm/s", Dimension::Velocity, 1_000),
    symbol("mm/s", Dimension::Velocity, 1_000_000),
    symbol("m/s", Dimension::Velocity, 1_000_000_000),
    symbol("mdeg/s", Dimension::AngularVelocity, 1_000_000),
    symbol("deg/s", Dimension::AngularVelocity, 1_000_000_000),
    symbol("°/s", Dimension::AngularVelocity, 1_000_000_000),
    symbol("rpm", Dimension::AngularVelocity, 6_000_000_000),
    symbol("µm/s²", Dimension::Acceleration, 1_000),
    symbol("mm/s²", Dimension::Acceleration, 1_000_000),
    symbol("m/s²", Dimension::Acceleration, 1_000_000_000),
    symbol("mdeg/s²", Dimension::AngularAcceleration, 1_000_000),
    symbol("deg/s²", Dimension::AngularAcceleration, 1_000_000_000),
    symbol("°/s²", Dimension::AngularAcceleration, 1_000_000_000),
    symbol("mN", Dimension::Force, 1_000_000),
    symbol("N", Dimension::Force, 1_000_000_000),
    symbol("mNm", Dimension::Torque, 1_000_000),
    symbol("Nm", Dimension::Torque, 1_000_000_000),
    symbol("mA", Dimension::Current, 1_000_000),
    symbol("A", Dimension::Current, 1_000_000_000),
    symbol("mV", Dimension::Voltage, 1_000_000),
    symbol("V", Dimension::Voltage, 1_000_000_000),
    symbol("ns", Dimension::Time, 1),
    symbol("µs", Dimension::Time, 1_000),
    symbol("ms", Dimension::Time, 1_000_000),
    symbol("s", Dimension::Time, 1_000_000_000),
    symbol("‰", Dimension::Ratio, 1_000_000),
    symbol("%", Dimension::Ratio, 10_000_000),
];

/// Words for quantities, and what each of them can be; a ratio can be a part of anything.
const QUANTITIES: &[(&[&str], &[Dimension])] = &[
    (&["length"], &[Dimension::Length]),
    (&["angle"], &[Dimension::Angle]),
    (&["position", "distance", "following error"], &[Dimension::Length, Dimension::Angle]),
    (&["velocity", "speed"], &[Dimension::Velocity, Dimension::AngularVelocity]),
    (&["angular velocity", "rotational speed"], &[Dimension::AngularVelocity]),
    (&["acceleration", "deceleration"], &[Dimension::Acceleration, Dimension::AngularAcceleration]),
    (&["angular acceleration", "angular deceleration"], &[Dimension::AngularAcceleration]),
    (&["force"], &[Dimension::Force]),
    (&["torque"], &[Dimension::Torque]),
    (&["current"], &[Dimension::Current]),
    (&["voltage"], &[Dimension::Voltage]),
    (&["time", "duration"], &[Dimension::Time]),
    (&["jerk", "temperature", "frequency", "power", "energy"], &[]),
];
