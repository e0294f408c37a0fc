//! Units and scaling.

#[cfg(any(feature = "esi", feature = "import"))]
mod code;

use std::fmt;

use super::compare::value;
use super::table::part;
use super::{Address, Source, model, plain};
use crate::source::Origin;
#[cfg(any(feature = "esi", feature = "import"))]
pub(crate) use code::UnitCode;

model! {
    /// What a raw number means.
    pub struct Unit by id {
        /// The word for it.
        pub id: String,
        /// The physical quantity.
        pub quantity: String,
        /// What it is on each axis, in order; one for all if there is only one.
        pub axes: Vec<AxisUnit>,
        /// The object that holds the scaling, on the first axis.
        pub factor: Option<Address>,
        /// How the values travel; either way if none.
        pub path: Option<Path>,
        /// What else is to be said.
        pub about: Option<String>,
        /// Where its facts are from.
        pub source: Option<Source>,
        /// Where it was written.
        #[cfg_attr(feature = "json", serde(rename = "provenance"))]
        pub origin: Origin,
    }

    /// What a raw number means on an axis.
    #[derive(Eq)]
    pub struct AxisUnit {
        /// The unit of the scaled value.
        pub symbol: String,
        /// Raw steps to one unit; the raw number is in units if none.
        pub scale: Option<Scale>,
    }

}

plain! {
    /// Raw steps to one unit, as a fraction in lowest terms.
    #[derive(Copy, Eq)]
    pub struct Scale {
        /// Raw steps.
        pub raw: u64,
        /// The units that they make.
        pub units: u64,
    }
}

part! {
    /// How a value travels.
    #[derive(Copy, Eq)]
    pub enum Path {
        /// In process data.
        Pdo,
        /// Through the mailbox.
        Sdo,
    }
}

value! { Scale }

impl Scale {
    /// So many raw steps to so many units, in lowest terms. Neither is 0.
    pub fn lowest(raw: u64, units: u64) -> Self {
        let (mut a, mut b) = (raw, units);
        while b != 0 {
            (a, b) = (b, a % b);
        }
        let divisor = a.max(1);
        Self { raw: raw / divisor, units: units / divisor }
    }
}

impl Unit {
    /// What it is on an axis, or for the whole device.
    pub fn on(&self, axis: Option<u8>) -> Option<&AxisUnit> {
        axis.and_then(|axis| self.axes.get(usize::from(axis))).or(self.axes.first())
    }
}

impl fmt::Display for Scale {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.raw, self.units)
    }
}
