//! C for the EtherLab master (IgH): what it is to be told of a device, as functions over its `ecrt.h`.
//!
//! The master writes assignment and mapping by itself, so these are not among the SDOs. It writes SDOs in Pre-Operational
//! only: what a configuration writes during a later change of state is not here, and a comment says so.

use minijinja::context;
use minijinja::value::Serde;

use super::{Emitter, Files, Options, c, program, template};
use crate::diagnostic::Rule;
use crate::lint::{Checked, rules};
use crate::model::{Device, Family};

/// Makes C for the EtherLab master.
#[derive(Debug)]
pub struct Igh;

/// What it cannot hold.
const LINTS: &[&Rule] = &[&rules::clashing_identifier::RULE, &rules::empty_name::RULE];

impl Emitter for Igh {
    fn name(&self) -> &'static str {
        "igh"
    }

    fn summary(&self) -> &'static str {
        "C for the EtherLab master: process data, SDOs and clocks over ecrt.h"
    }

    fn ends(&self) -> &'static [&'static str] {
        &[".igh.c"]
    }

    fn lints(&self) -> &'static [&'static Rule] {
        LINTS
    }

    fn is_default(&self) -> bool {
        false
    }

    fn emit(&self, family: &Checked<Family>, _: &Options) -> Files {
        let files = family.members.iter();
        Files(files.map(|it| (format!("{}.igh.c", it.id), tables(it, &family.id).into_bytes())).collect())
    }
}

fn tables(device: &Device, family: &str) -> String {
    let setups = program::setups(device);
    let it = program::Program::of(device, family, &[]);
    let has_places = device.sync_managers.iter().any(|manager| manager.role.is_process_data());
    let context = context! { it => Serde(&it), setups => Serde(setups), has_places };
    template::render("tables.c", include_str!("tables.c.j2"), c::filters, context)
}
