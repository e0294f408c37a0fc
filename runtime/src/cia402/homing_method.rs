//! Ways to find the reference.

use core::fmt;

/// What a device's description says about a way to find the reference (CiA 402, homing methods).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HomingInfo {
    /// The number in 0x6098.
    pub number: i8,
    /// The name of the method.
    pub name: &'static str,
    /// Where the axis starts to; none if it does not move.
    pub direction: Option<Direction>,
    /// Whether the method ends on an index pulse.
    pub pulse: bool,
    /// What it looks for besides, such as a switch; empty if nothing.
    pub target: &'static str,
    /// What the drive does; empty where the manual has nothing to say.
    pub text: &'static str,
}

impl HomingInfo {
    /// All of it in the order of the fields, for generated tables.
    pub const fn new(
        number: i8,
        name: &'static str,
        direction: Option<Direction>,
        pulse: bool,
        target: &'static str,
        text: &'static str,
    ) -> Self {
        Self { number, name, direction, pulse, target, text }
    }
}

/// A direction of movement (CiA 402, homing methods).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Towards greater positions.
    Positive,
    /// Towards smaller positions.
    Negative,
}

/// The homing method of a device (CiA 402, homing method 0x6098): a newtype over `i8` in the generated module, with a
/// constant for each method that the device has.
///
/// Any number can stand in the object; one that the description does not have keeps its value.
///
/// ```
/// use devc_runtime::cia402::{Direction, HomingInfo, HomingMethod, homing_method};
///
/// #[derive(Clone, Copy)]
/// struct Method(i8);
///
/// impl HomingMethod for Method {
///     const TABLE: &'static [HomingInfo] = &[HomingInfo {
///         number: 17,
///         name: "homing on negative limit switch",
///         direction: Some(Direction::Negative),
///         pulse: false,
///         target: "negative limit switch",
///         text: "",
///     }];
///     fn number(self) -> i8 { self.0 }
/// }
///
/// assert_eq!(Method(17).info().unwrap().direction, Some(Direction::Negative));
/// assert_eq!(homing_method(Method(99)).to_string(), "99: unknown homing method");
/// ```
pub trait HomingMethod: Copy {
    /// The methods that the device has, by number; a second number of a method has a row of its own.
    const TABLE: &'static [HomingInfo];

    /// The number on the wire.
    fn number(self) -> i8;

    /// What the description says about the method, if the device has it.
    fn info(self) -> Option<&'static HomingInfo> {
        let position = Self::TABLE.binary_search_by_key(&self.number(), |info| info.number).ok()?;
        Self::TABLE.get(position)
    }

    /// The name of the method, if the device has it.
    fn name(self) -> Option<&'static str> {
        self.info().map(|info| info.name)
    }
}

/// The number of a method and its name, for people.
pub fn homing_method(method: impl HomingMethod) -> impl fmt::Display {
    Shown { number: method.number(), name: method.name() }
}

struct Shown {
    number: i8,
    name: Option<&'static str>,
}

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.number, self.name.unwrap_or("unknown homing method"))
    }
}

impl Direction {
    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Positive => "positive",
            Self::Negative => "negative",
        }
    }
}

impl fmt::Display for Direction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
