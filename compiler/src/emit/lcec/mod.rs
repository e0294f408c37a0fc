//! XML for LinuxCNC-EtherCAT (`lcec`): a generic slave with a pin of HAL for each value, for what is by default and for each
//! configuration.
//!
//! lcec writes assignment and mapping by itself, so these are not among its SDOs. Numbers that name something are hexadecimal
//! there and have no prefix; all others are decimal.

mod pin;

use minijinja::value::Serde;
use minijinja::{Environment, context};

use super::escape::comment;
use super::program::{Head, Setup, each_way};
use super::{Emitter, Files, Options, template};
use crate::diagnostic::Rule;
use crate::lint::{Checked, rules};
use crate::model::Family;
use pin::pinned;

/// Makes configurations of lcec.
#[derive(Debug)]
pub struct Lcec;

/// What HAL cannot hold.
const LINTS: &[&Rule] = &[&rules::empty_name::RULE, &rules::overlong_pin::RULE, &rules::pinless_value::RULE];

/// The cycle of a master where no configuration says one: LinuxCNC's own default.
const CYCLE_NS: u64 = 1_000_000;

impl Emitter for Lcec {
    fn name(&self) -> &'static str {
        "lcec"
    }

    fn summary(&self) -> &'static str {
        "XML for LinuxCNC-EtherCAT: process data as pins, SDOs and clocks"
    }

    fn ends(&self) -> &'static [&'static str] {
        &[".lcec"]
    }

    fn lints(&self) -> &'static [&'static Rule] {
        LINTS
    }

    fn is_default(&self) -> bool {
        false
    }

    fn emit(&self, family: &Checked<Family>, _: &Options) -> Files {
        Files(each_way(family, ".lcec", slave))
    }
}

fn slave(it: &Head, setup: &Setup) -> String {
    let context = context! {
        it => Serde(it),
        setup => Serde(setup),
        managers => Serde(pinned(&setup.managers)),
        period => setup.cycle_ns.unwrap_or(CYCLE_NS),
    };
    template::render("slave.xml", include_str!("slave.xml.j2"), filters, context)
}

fn filters(environment: &mut Environment<'static>) {
    environment.add_filter("comment", |text: String| comment(&text));
}
