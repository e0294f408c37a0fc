//! Lua for Wireshark: a dissector of each member, which shows beside Wireshark's own one what frames mean to the device.
//!
//! A template holds the facts; what is done with them is Lua that is the same for all devices: `fields` and `history` for
//! what is known, `image`, `mailbox` and `frame` for what is shown.

mod codes;
mod entries;
mod images;
mod text;
mod words;

use minijinja::context;
use minijinja::value::Serde;

use super::program::Program;
use super::{Emitter, Files, Options, template};
use crate::diagnostic::Rule;
use crate::lint::{Checked, rules};
use crate::model::{Device, Family, Role};
use crate::text::characters::harmless;

/// Makes dissectors for Wireshark.
#[derive(Debug)]
pub struct Wireshark;

/// What a name is needed for.
const LINTS: &[&Rule] = &[&rules::clashing_identifier::RULE, &rules::empty_name::RULE];

/// What is the same for all devices, in the order in which it needs one another.
const PARTS: [&str; 5] = [
    include_str!("fields.lua"),
    include_str!("history.lua"),
    include_str!("image.lua"),
    include_str!("mailbox.lua"),
    include_str!("frame.lua"),
];

impl Emitter for Wireshark {
    fn name(&self) -> &'static str {
        "wireshark"
    }

    fn summary(&self) -> &'static str {
        "Lua for Wireshark: process data, words, states, SDOs and errors by name"
    }

    fn ends(&self) -> &'static [&'static str] {
        &[".lua"]
    }

    fn lints(&self) -> &'static [&'static Rule] {
        LINTS
    }

    fn is_default(&self) -> bool {
        false
    }

    fn emit(&self, family: &Checked<Family>, _: &Options) -> Files {
        let files = family.members.iter();
        Files(files.map(|it| (format!("{}.lua", it.id), dissector(it, &family.id).into_bytes())).collect())
    }
}

fn dissector(device: &Device, family: &str) -> String {
    let it = Program::of(device, family, &[]);
    let place = |role| device.sync_manager(role).map_or("nil".to_owned(), |it| it.number.to_string());
    let places = context! {
        mailbox_out => place(Role::MailboxOut),
        mailbox_in => place(Role::MailboxIn),
    };
    let (objects, entries) = entries::dictionary(device);
    let context = context! {
        places,
        words => Serde(words::words(&it)),
        al_codes => Serde(codes::al_codes(&it)),
        objects => Serde(objects),
        entries => Serde(entries),
        pdos => Serde(it.selections.first().map(|first| &first.pdos)),
        assigned => Serde(images::by_default(&it)),
        configurations => Serde(images::configurations(&it)),
        it => Serde(&it),
    };
    let facts = template::render("dissector.lua", include_str!("dissector.lua.j2"), text::filters, context);
    let parts = PARTS.into_iter().map(harmless);
    parts.fold(facts, |text, part| text + &part)
}
