//! The description of the PMC SC6 and PMC SI6 against the tables of their manual, fact by fact.

#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

mod coordinates;
#[path = "../described/mod.rs"]
mod described;
mod dictionary;
mod faults;
mod homing;
mod modes;
mod process_data;
mod service;
mod states;

use std::sync::LazyLock;

use devc::lint::Checked;
use devc::model::{Device, Family};
use devc_tests::manual::{AxisLetter, pmc_sc6};

use described::{departs, plain, rows};

/// The family as `devices/pmc-sc6` describes it.
fn family() -> &'static Family {
    static FAMILY: LazyLock<Checked<Family>> = LazyLock::new(|| described::family("pmc-sc6"));
    &FAMILY
}

/// The member with two axes and the application CiA 402, which has all that the tables have.
fn device() -> &'static Device {
    family().members.iter().find(|device| device.id == "double").expect("there is one with two axes")
}

/// The number of an axis, from 0.
fn number(axis: AxisLetter) -> u8 {
    match axis {
        AxisLetter::A => 0,
        AxisLetter::B => 1,
    }
}

/// A fact that stands in no table.
fn fact(key: &str) -> &'static str {
    let facts = rows::<pmc_sc6::Fact>();
    facts.iter().find(|fact| fact.key == key).unwrap_or_else(|| panic!("there is no fact {key}")).value
}

#[test]
fn members_are_axes_with_applications() {
    let applications = fact("applications").split(", ");
    let expected = applications.flat_map(|application| [(2, application), (1, application)]);
    let expected: Vec<_> = expected.map(|(axes, name)| (axes, name.to_owned())).collect();
    let members = family().members.iter();
    let described =
        members.map(|it| (it.axes.len(), it.name.rsplit(", ").next().unwrap_or_default().to_owned()));
    assert_eq!(described.collect::<Vec<_>>(), expected);
    assert_eq!(device().axes.len().to_string(), fact("axes"));
}

#[test]
fn members_with_two_axes_have_the_same_interface() {
    for other in family().members.iter().filter(|other| other.axes.len() == 2) {
        let addresses = |of: &Device| -> Vec<_> {
            of.objects
                .iter()
                .flat_map(|object| &object.entries)
                .map(|entry| (entry.address, entry.pdo))
                .collect()
        };
        assert_eq!(addresses(other), addresses(device()));
        assert_eq!((&other.modes, &other.states), (&device().modes, &device().states));
        assert_eq!(other.homing_methods, device().homing_methods);
    }
}

#[test]
fn members_with_one_axis_have_axis_a() {
    for single in family().members.iter().filter(|other| other.axes.len() == 1) {
        let indices = |of: &Device| -> Vec<_> {
            let own = of.objects.iter().filter(|object| object.axis != Some(1) && object.index.0 >= 0x2000);
            own.map(|object| object.index).collect()
        };
        assert_eq!(indices(single), indices(device()));
        assert!(single.objects.iter().all(|object| object.axis != Some(1)));
    }
}
