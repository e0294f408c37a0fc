//! Cycle times: those that a device takes, and how 0x60C2 holds them.

use crate::MappedPdo;
use crate::mapping::has;

/// A cycle time as 0x60C2 holds it (CiA 402, interpolation time period).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Period {
    /// How many units it is.
    pub count: u8,
    /// The unit, as a power of ten in seconds.
    pub exponent: i8,
}

impl Period {
    /// A time in nanoseconds, in the largest unit up to a millisecond in which it is a whole number, or in a larger one if the
    /// count needs it; none if it is no count of up to 255 of a power of ten.
    ///
    /// ```
    /// use devc_start_up::Period;
    ///
    /// assert_eq!(Period::of_ns(250_000), Some(Period { count: 25, exponent: -5 }));
    /// assert_eq!(Period::of_ns(1_000_000), Some(Period { count: 1, exponent: -3 }));
    /// assert_eq!(Period::of_ns(1_234_000), None);
    /// ```
    pub const fn of_ns(ns: u64) -> Option<Self> {
        let (mut count, mut exponent) = (ns, -9);
        while count != 0 && count.is_multiple_of(10) && (exponent < -3 || count > 255) {
            count /= 10;
            exponent += 1;
        }
        match count {
            1..=255 => Some(Self { count: count as u8, exponent }),
            _ => None,
        }
    }
}

/// Cycle times that a device takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CycleLimit<'a> {
    /// The shortest in nanoseconds; 0 if none is told.
    pub least_ns: u64,
    /// The only ones, in nanoseconds; any if there are none.
    pub choices_ns: &'a [u64],
    /// The modes of operation that it holds for; for all that have none of their own if there are none.
    pub modes: &'a [i8],
    /// The PDOs that are meant for these modes, by index.
    pub pdos: &'a [u16],
}

/// How a device is going to be run, as far as its cycle time depends on that.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Interface<'a> {
    /// The mode of operation, if it is chosen.
    pub mode: Option<i8>,
    /// The PDOs of each direction. Where no mode is chosen, they tell which one they are for.
    pub pdos: [&'a [MappedPdo<'a>]; 2],
}

impl Interface<'_> {
    /// Whether one of the limits that hold for it takes a cycle time; where none does, any is taken.
    ///
    /// ```
    /// use devc_start_up::{CycleLimit, Interface, MappedPdo};
    ///
    /// let position = CycleLimit { least_ns: 1_000_000, choices_ns: &[], modes: &[8], pdos: &[0x1701] };
    /// let torque = CycleLimit { least_ns: 250_000, choices_ns: &[], modes: &[10], pdos: &[0x1703] };
    /// let limits = [position, torque];
    ///
    /// let in_mode = |mode| Interface { mode, pdos: [&[], &[]] };
    /// assert!(!in_mode(Some(8)).takes(&limits, 250_000) && in_mode(Some(10)).takes(&limits, 250_000));
    /// assert!(in_mode(None).takes(&limits, 250_000) && in_mode(Some(6)).takes(&limits, 250_000));
    ///
    /// let setpoint = [MappedPdo::new(0x1701, &[])];
    /// assert!(!Interface { mode: None, pdos: [&setpoint, &[]] }.takes(&limits, 250_000));
    /// ```
    pub const fn takes(&self, mut limits: &[CycleLimit<'_>], ns: u64) -> bool {
        let (mut own, mut others) = (None, None);
        while let Some((limit, rest)) = limits.split_first() {
            if self.is_named(limit) {
                own = either(own, limit.takes(ns));
            } else if self.mode.is_none() || limit.modes.is_empty() {
                others = either(others, limit.takes(ns));
            }
            limits = rest;
        }
        match (own, others) {
            (Some(takes), _) | (None, Some(takes)) => takes,
            (None, None) => true,
        }
    }

    /// Whether a limit names its mode, or PDOs of it.
    const fn is_named(&self, limit: &CycleLimit<'_>) -> bool {
        let Some(mode) = self.mode else {
            let [some, others] = self.pdos;
            return limit.has_pdo_of(some) || limit.has_pdo_of(others);
        };
        let mut modes = limit.modes;
        while let Some((named, rest)) = modes.split_first() {
            if *named == mode {
                return true;
            }
            modes = rest;
        }
        false
    }
}

const fn either(before: Option<bool>, now: bool) -> Option<bool> {
    Some(now || matches!(before, Some(true)))
}

impl CycleLimit<'_> {
    const fn takes(&self, ns: u64) -> bool {
        let mut choices = self.choices_ns;
        let mut is_choice = choices.is_empty();
        while let Some((choice, rest)) = choices.split_first() {
            is_choice = is_choice || *choice == ns;
            choices = rest;
        }
        is_choice && ns >= self.least_ns
    }

    const fn has_pdo_of(&self, mut pdos: &[MappedPdo<'_>]) -> bool {
        while let Some((pdo, rest)) = pdos.split_first() {
            if has(self.pdos, pdo.index) {
                return true;
            }
            pdos = rest;
        }
        false
    }
}
