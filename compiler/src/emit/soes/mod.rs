//! The object list for SOES, as the files that the stack includes by name: one folder a member.
//!
//! The tables are in the form that `esc_coe.h` declares; nothing of the stack is in them. Values that a firmware reads or
//! writes are members of one struct, which the table points to.

mod entry;
mod memory;

use minijinja::context;
use minijinja::value::Serde;

use super::identifier::Claimed;
use super::program::Program;
use super::{Emitter, Files, Options, c, template};
use crate::diagnostic::Rule;
use crate::lint::{Checked, rules};
use crate::model::{Device, Family};

/// Makes object lists for SOES.
#[derive(Debug)]
pub struct Soes;

/// What it cannot hold.
const LINTS: &[&Rule] = &[
    &rules::clashing_identifier::RULE,
    &rules::empty_name::RULE,
    &rules::foreign_protocol::RULE,
    &rules::overlong_value::RULE,
    &rules::surplus_sync_manager::RULE,
    &rules::uncopied_value::RULE,
];

/// The files, by the names that the stack and its programs include, with what lays each out.
const FILES: [(&str, &str); 3] = [
    (".soes/slave_objectlist.c", include_str!("slave_objectlist.c.j2")),
    (".soes/utypes.h", include_str!("utypes.h.j2")),
    (".soes/ecat_options.h", include_str!("ecat_options.h.j2")),
];

impl Emitter for Soes {
    fn name(&self) -> &'static str {
        "soes"
    }

    fn summary(&self) -> &'static str {
        "C for SOES: the object list, its values and the options of each member"
    }

    fn ends(&self) -> &'static [&'static str] {
        const { &[FILES[0].0, FILES[1].0, FILES[2].0] }
    }

    fn lints(&self) -> &'static [&'static Rule] {
        LINTS
    }

    fn is_default(&self) -> bool {
        false
    }

    fn emit(&self, family: &Checked<Family>, _: &Options) -> Files {
        Files(family.members.iter().flat_map(|device| member(device, &family.id)).collect())
    }
}

fn member(device: &Device, family: &str) -> impl Iterator<Item = (String, Vec<u8>)> {
    let program = Program::of(device, family, c::KEYWORDS);
    let mut taken = Claimed::with(&[]);
    let objects = device.objects.iter().zip(&program.objects);
    let objects: Vec<_> = objects.map(|(object, named)| entry::object(object, named, &mut taken)).collect();
    let context = context! {
        it => Serde(&program),
        objects => Serde(&objects),
        has_values => objects.iter().any(entry::Object::has_values),
        memory => Serde(memory::of(device)),
    };
    FILES.into_iter().map(move |(end, text)| {
        let text = template::render(end, text, c::filters, context.clone());
        (format!("{}{end}", device.id), text.into_bytes())
    })
}
