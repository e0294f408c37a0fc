//! Physical quantities.

use core::fmt;

mod sealed {
    pub trait Sealed {}
}

/// A physical quantity: a whole number of its smallest unit, a billionth of the one it is shown in.
///
/// The smallest units are fine enough for every scale of the field, and their range is wide enough for every machine
/// (9.2 million kilometres, 25 million revolutions): values beyond it stay at its end.
///
/// ```
/// use devc_runtime::unit::{AngularVelocity, Length, Ratio};
///
/// assert_eq!(Length::millimetres(15), Length::micrometres(15_000));
/// assert_eq!(Length::millimetres(15).in_metres(), 0.015);
/// assert_eq!(AngularVelocity::rpm(1), AngularVelocity::degrees_per_second(6));
/// assert_eq!(Length::micrometres(-1500).to_string(), "-0.0015 m");
/// assert_eq!(Ratio::permille(125).to_string(), "12.5 %");
/// ```
///
/// A length is no angle, and a number is neither:
///
/// ```compile_fail,E0308
/// # use devc_runtime::unit::{Angle, Length};
/// let turn: Angle = Length::millimetres(15);
/// ```
pub trait Quantity: Copy + sealed::Sealed {
    /// From a number of the smallest unit.
    fn from_smallest(number: i64) -> Self;

    /// In the smallest unit.
    fn smallest(self) -> i64;
}

macro_rules! quantities {
    ($(
        $(#[$doc:meta])*
        $name:ident [$symbol:literal $(= $shown:expr)?] {
            $($unit:ident / $as_float:ident = $size:literal, $plural:literal;)+
        }
    )+) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
        pub struct $name(i64);

        impl $name {
            $(
                #[doc = concat!("So many ", $plural, ".")]
                #[inline]
                pub const fn $unit(number: i64) -> Self {
                    Self(number.saturating_mul($size))
                }

                #[doc = concat!("As ", $plural, ", with their fraction, as near as `f64` comes.")]
                #[inline]
                pub fn $as_float(self) -> f64 {
                    self.0 as f64 / ($size as i64) as f64
                }
            )+

            /// The sum, at the end of the range if it is beyond it.
            #[inline]
            #[must_use]
            pub const fn saturating_add(self, other: Self) -> Self {
                Self(self.0.saturating_add(other.0))
            }

            /// The difference, at the end of the range if it is beyond it.
            #[inline]
            #[must_use]
            pub const fn saturating_sub(self, other: Self) -> Self {
                Self(self.0.saturating_sub(other.0))
            }
        }

        impl sealed::Sealed for $name {}

        impl Quantity for $name {
            #[inline]
            fn from_smallest(number: i64) -> Self {
                Self(number)
            }

            #[inline]
            fn smallest(self) -> i64 {
                self.0
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let shown: &[(usize, u64)] = &[$($shown,)? (9, 1_000_000_000)];
                let (places, unit) = shown.first().copied().unwrap_or((0, 1));
                show(f, self.0, unit, places, $symbol)
            }
        }
    )+};
}

quantities! {
    /// A length or a position on a line, in nanometres.
    Length ["m"] {
        nanometres / in_nanometres = 1, "nanometres";
        micrometres / in_micrometres = 1_000, "micrometres";
        millimetres / in_millimetres = 1_000_000, "millimetres";
        metres / in_metres = 1_000_000_000, "metres";
    }
    /// An angle, in billionths of a degree.
    Angle ["°"] {
        microdegrees / in_microdegrees = 1_000, "millionths of a degree";
        millidegrees / in_millidegrees = 1_000_000, "thousandths of a degree";
        degrees / in_degrees = 1_000_000_000, "degrees";
        revolutions / in_revolutions = 360_000_000_000, "revolutions";
    }
    /// A velocity along a line, in nanometres a second.
    Velocity ["m/s"] {
        micrometres_per_second / in_micrometres_per_second = 1_000, "micrometres a second";
        millimetres_per_second / in_millimetres_per_second = 1_000_000, "millimetres a second";
        metres_per_second / in_metres_per_second = 1_000_000_000, "metres a second";
    }
    /// A velocity of turning, in billionths of a degree a second.
    AngularVelocity ["°/s"] {
        millidegrees_per_second / in_millidegrees_per_second = 1_000_000, "thousandths of a degree a second";
        degrees_per_second / in_degrees_per_second = 1_000_000_000, "degrees a second";
        rpm / in_rpm = 6_000_000_000, "revolutions a minute";
    }
    /// An acceleration along a line, in nanometres per second squared.
    Acceleration ["m/s²"] {
        micrometres_per_second_squared / in_micrometres_per_second_squared = 1_000,
            "micrometres per second squared";
        millimetres_per_second_squared / in_millimetres_per_second_squared = 1_000_000,
            "millimetres per second squared";
        metres_per_second_squared / in_metres_per_second_squared = 1_000_000_000, "metres per second squared";
    }
    /// An acceleration of turning, in billionths of a degree per second squared.
    AngularAcceleration ["°/s²"] {
        millidegrees_per_second_squared / in_millidegrees_per_second_squared = 1_000_000,
            "thousandths of a degree per second squared";
        degrees_per_second_squared / in_degrees_per_second_squared = 1_000_000_000,
            "degrees per second squared";
    }
    /// A force, in nanonewtons.
    Force ["N"] {
        millinewtons / in_millinewtons = 1_000_000, "millinewtons";
        newtons / in_newtons = 1_000_000_000, "newtons";
    }
    /// A torque, in billionths of a newton metre.
    Torque ["Nm"] {
        millinewton_metres / in_millinewton_metres = 1_000_000, "thousandths of a newton metre";
        newton_metres / in_newton_metres = 1_000_000_000, "newton metres";
    }
    /// A current, in nanoamperes.
    Current ["A"] {
        milliamperes / in_milliamperes = 1_000_000, "milliamperes";
        amperes / in_amperes = 1_000_000_000, "amperes";
    }
    /// A voltage, in nanovolts.
    Voltage ["V"] {
        millivolts / in_millivolts = 1_000_000, "millivolts";
        volts / in_volts = 1_000_000_000, "volts";
    }
    /// A time, in nanoseconds.
    Time ["s"] {
        nanoseconds / in_nanoseconds = 1, "nanoseconds";
        microseconds / in_microseconds = 1_000, "microseconds";
        milliseconds / in_milliseconds = 1_000_000, "milliseconds";
        seconds / in_seconds = 1_000_000_000, "seconds";
    }
    /// A part of something, such as of a rated torque, in billionths.
    Ratio ["%" = (7, 10_000_000)] {
        permille / in_permille = 1_000_000, "thousandths";
        percent / in_percent = 10_000_000, "hundredths";
        wholes / in_wholes = 1_000_000_000, "wholes";
    }
}

/// As a decimal number with its sign and as many places as it needs, of a unit that is so many of the smallest: a power of
/// ten with so many places.
fn show(
    f: &mut fmt::Formatter<'_>,
    smallest: i64,
    unit: u64,
    mut places: usize,
    symbol: &str,
) -> fmt::Result {
    let sign = if smallest < 0 { "-" } else { "" };
    let number = smallest.unsigned_abs();
    let (whole, mut part) = (number.checked_div(unit).unwrap_or(0), number.checked_rem(unit).unwrap_or(0));
    if part == 0 {
        return write!(f, "{sign}{whole} {symbol}");
    }
    while part % 10 == 0 {
        part /= 10;
        places = places.saturating_sub(1);
    }
    write!(f, "{sign}{whole}.{part:0places$} {symbol}")
}
