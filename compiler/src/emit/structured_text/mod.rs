//! Structured Text of IEC 61131-3: types, constants and functions for programs of a PLC, one file a member.

mod layout;
mod text;

use minijinja::context;
use minijinja::value::Serde;

use super::program::Program;
use super::{Emitter, Files, Options, template};
use crate::diagnostic::Rule;
use crate::lint::{Checked, rules};
use crate::model::{Device, Family};

/// Makes Structured Text.
#[derive(Debug)]
pub struct StructuredText;

/// What it cannot hold.
const LINTS: &[&Rule] = &[
    &rules::clashing_identifier::RULE,
    &rules::empty_name::RULE,
    &rules::unaligned_value::RULE,
    &rules::unspellable_text::RULE,
];

impl Emitter for StructuredText {
    fn name(&self) -> &'static str {
        "structured-text"
    }

    fn summary(&self) -> &'static str {
        "Structured Text of IEC 61131-3: identity, indices, modes, words, states, errors, start-up lists, process data"
    }

    fn ends(&self) -> &'static [&'static str] {
        &[".st"]
    }

    fn lints(&self) -> &'static [&'static Rule] {
        LINTS
    }

    fn is_default(&self) -> bool {
        false
    }

    fn emit(&self, family: &Checked<Family>, _: &Options) -> Files {
        let texts = family.members.iter();
        Files(texts.map(|it| (format!("{}.st", it.id), program(it, &family.id).into_bytes())).collect())
    }
}

fn program(device: &Device, family: &str) -> String {
    let program = Program::of(device, family, &[]);
    let pdos = program.selections.iter().flat_map(|selection| &selection.pdos);
    let records: Vec<_> = pdos.map(layout::record).collect();
    let writes = program.start_ups.iter().flat_map(|list| &list.writes);
    let longest = writes.map(|write| write.data.len()).fold(1, usize::max);
    let context = context! { it => Serde(&program), records => Serde(records), longest };
    template::render("program.st", include_str!("program.st.j2"), text::filters, context)
}
