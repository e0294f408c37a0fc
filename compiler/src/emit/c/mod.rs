//! C for firmware and masters: one header a member, C99 and C++, that leans on no stack.

mod packing;
mod record;
mod text;

#[cfg(feature = "soes")]
pub(super) use text::KEYWORDS;
pub(super) use text::filters;

use minijinja::context;
use minijinja::value::Serde;

use super::program::Program;
use super::{Emitter, Files, Options, template};
use crate::diagnostic::Rule;
use crate::lint::{Checked, rules};
use crate::model::{Device, Family};

/// Makes headers of C.
#[derive(Debug)]
pub struct C;

/// What it cannot hold.
const LINTS: &[&Rule] = &[&rules::clashing_identifier::RULE, &rules::empty_name::RULE];

impl Emitter for C {
    fn name(&self) -> &'static str {
        "c"
    }

    fn summary(&self) -> &'static str {
        "C and C++: identity, indices, words, states, errors, process data, start-up lists"
    }

    fn ends(&self) -> &'static [&'static str] {
        &[".h"]
    }

    fn lints(&self) -> &'static [&'static Rule] {
        LINTS
    }

    fn is_default(&self) -> bool {
        false
    }

    fn emit(&self, family: &Checked<Family>, _: &Options) -> Files {
        let headers = family.members.iter();
        Files(
            headers
                .map(|device| (format!("{}.h", device.id), header(device, &family.id).into_bytes()))
                .collect(),
        )
    }
}

fn header(device: &Device, family: &str) -> String {
    let program = Program::of(device, family, text::KEYWORDS);
    let records = record::records(&program);
    let context = context! { it => Serde(&program), records => Serde(records) };
    template::render("header.h", include_str!("header.h.j2"), filters, context)
}
