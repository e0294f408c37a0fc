//! Axes, and how they share the dictionary.

use devc_start_up::AxisObjects;

use super::table::table;
use super::{Index, Object, Source, model};
use crate::source::Origin;

model! {
    /// An axis of a device.
    pub struct Axis by number {
        /// Its number, from 0.
        pub number: u8,
        /// Its name.
        pub name: String,
        /// What it does.
        pub about: Option<String>,
    }

    /// How the axes share the dictionary, and depend on each other.
    pub struct Arrangement {
        /// Which objects exist once for each axis.
        pub shifts: Vec<Shift>,
        /// The distance between the PDOs of two axes.
        pub pdo_shift: u16,
        /// What each axis is, as the upper half of 0x1000 says it of a device with one axis.
        pub add_info: Option<u16>,
        /// How the axes depend on each other.
        pub coupling: Option<String>,
        /// Where these facts are from.
        pub source: Option<Source>,
        /// Where `[axes]` stands.
        #[cfg_attr(feature = "json", serde(rename = "provenance"))]
        pub origin: Origin,
    }

    /// A range of indices that exists once for each axis.
    pub struct Shift by first {
        /// The first index of the first axis.
        pub first: Index,
        /// The last index of the first axis.
        pub last: Index,
        /// The distance from an axis to the next.
        pub by: u16,
    }
}

table! {
    /// `[areas."<index>..=<index>"]`: a title for a range of the dictionary.
    pub struct Area by first to last: "a range of indices such as \"0x2000..=0x5FFF\"" {
        /// The first index.
        #[serde(skip_deserializing)]
        pub first: Index,
        /// The last index.
        #[serde(skip_deserializing)]
        pub last: Index,
        /// The title.
        pub name: String,
        /// What the objects in it are for.
        pub about: Option<String>,
    }
}

impl Axis {
    /// What a master sets once on each axis, where it does anything.
    pub(crate) fn set_objects(axes: &[Axis], objects: &[Object]) -> Vec<AxisObjects> {
        let of = |leading: u16| -> Vec<&Object> {
            let objects = objects.iter().filter(|object| object.leading == Index(leading));
            objects.filter(|object| object.functional).collect()
        };
        let (modes, cycles) = (of(0x6060), of(0x60C2));
        let on = |axis: &Axis, objects: &[&Object]| {
            let object = objects.iter().find(|object| object.axis.unwrap_or_default() == axis.number);
            object.map(|object| object.index.0)
        };
        axes.iter().map(|axis| AxisObjects { mode: on(axis, &modes), cycle: on(axis, &cycles) }).collect()
    }
}
