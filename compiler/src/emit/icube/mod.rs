//! YAML for `ethercat_driver_ros2`: a slave with a channel for each value, for what is by default and for each configuration.
//!
//! A device with one axis fits the drive plug-in, which finds the objects of CiA 402 by index and runs the state machine; the
//! names of interfaces are those that controllers of ROS 2 know. With several axes each value has a name of its own.

mod channel;

use minijinja::value::Serde;
use minijinja::{Environment, context};

use super::program::{Head, Setup, each_way};
use super::{Emitter, Files, Options, template};
use crate::diagnostic::Rule;
use crate::lint::{Checked, rules};
use crate::model::Family;
use crate::text::characters::line;
use channel::{channels, writes};

/// Makes configurations of `ethercat_driver_ros2`.
#[derive(Debug)]
pub struct Icube;

/// What the driver cannot hold.
const LINTS: &[&Rule] = &[
    &rules::channelless_value::RULE,
    &rules::empty_name::RULE,
    &rules::oversized_write::RULE,
    &rules::uncontrolled_axis::RULE,
];

impl Emitter for Icube {
    fn name(&self) -> &'static str {
        "icube"
    }

    fn summary(&self) -> &'static str {
        "YAML for ethercat_driver_ros2: process data as interfaces, SDOs and clocks"
    }

    fn ends(&self) -> &'static [&'static str] {
        &[".yaml"]
    }

    fn lints(&self) -> &'static [&'static Rule] {
        LINTS
    }

    fn is_default(&self) -> bool {
        false
    }

    fn emit(&self, family: &Checked<Family>, _: &Options) -> Files {
        Files(each_way(family, ".yaml", slave))
    }
}

fn slave(it: &Head, setup: &Setup) -> String {
    let writes = writes(setup);
    let context = context! {
        it => Serde(it),
        setup => Serde(setup),
        left => setup.sdos.len() - writes.len(),
        writes => Serde(writes),
        outputs => Serde(channels(setup, true, it.has_axes)),
        inputs => Serde(channels(setup, false, it.has_axes)),
    };
    template::render("slave.yaml", include_str!("slave.yaml.j2"), filters, context)
}

fn filters(environment: &mut Environment<'static>) {
    environment.add_filter("line", |text: String| line(&text).into_owned());
}
