//! Registers of the EtherCAT slave controller, and the bytes of messages.

use serde::Serialize;

use super::words;
use crate::emit::markdown::chapter::Chapter;
use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{code, text};
use crate::emit::markdown::number::bytes;
use crate::emit::markdown::table::Table;
use crate::model::{Register, RegisterAccess, Telegram};

#[derive(Serialize)]
pub(in crate::emit::markdown) struct View {
    registers: Table,
    bits: Vec<FieldsView>,
    telegrams: Vec<FieldsView>,
}

/// The bits of a register, or the bytes of a message.
#[derive(Serialize)]
struct FieldsView {
    title: String,
    about: String,
    fields: Table,
    source: String,
}

impl Chapter for View {
    type Parts<'d> = (&'d [Register], &'d [Telegram]);

    const ID: &'static str = "registers";
    const TITLE: &'static str = "Registers and messages";
    const TEMPLATE: &'static str = include_str!("../templates/registers.md.j2");

    fn view(context: &Context<'_>, (registers, telegrams): Self::Parts<'_>) -> Option<Self> {
        let with_bits = registers.iter().filter(|register| !register.fields.is_empty());
        (!registers.is_empty() || !telegrams.is_empty()).then(|| Self {
            registers: table(context, registers),
            bits: with_bits.map(|register| bits(context, register)).collect(),
            telegrams: telegrams.iter().map(|telegram| message(context, telegram)).collect(),
        })
    }
}

fn table(context: &Context<'_>, registers: &[Register]) -> Table {
    let titles = ["Address", "Register", "Length", "Master", "Drive", "Notes", "Source"];
    Table::of(titles, registers, |register| {
        // The fields have a table of their own.
        let Register { address, length, name, ecat, drive, fields: _, about, source, origin } = register;
        [
            hex(*address),
            format!("**{}**", text(name)),
            bytes((*length).into()),
            access(*ecat).into(),
            access(*drive).into(),
            context.optional(about.as_deref()),
            context.said(source.as_ref(), origin),
        ]
    })
}

fn hex(address: u16) -> String {
    code(format!("0x{address:04X}"))
}

fn access(access: RegisterAccess) -> &'static str {
    match access {
        RegisterAccess::None => "–",
        RegisterAccess::R => "r",
        RegisterAccess::W => "w",
        RegisterAccess::Rw => "rw",
    }
}

fn bits(context: &Context<'_>, register: &Register) -> FieldsView {
    FieldsView {
        title: format!("{} {}", hex(register.address), text(&register.name)),
        about: String::new(),
        fields: fields(context, "Bit", &register.fields),
        source: String::new(),
    }
}

fn message(context: &Context<'_>, telegram: &Telegram) -> FieldsView {
    let Telegram { id: _, name, address, fields, about, source, origin } = telegram;
    let address = address.map_or(String::new(), |address| format!(" at {}", hex(address)));
    FieldsView {
        title: format!("{}{address}", text(name)),
        about: context.paragraphs(about.as_deref()),
        fields: self::fields(context, "Byte", fields),
        source: context.said_line(source.as_ref(), origin),
    }
}

fn fields(context: &Context<'_>, title: &str, fields: &[crate::model::Field]) -> Table {
    words::table(title, fields, |field| words::statements(context, field).join("<br>"))
}
