//! Registers of the EtherCAT slave controller, and the bytes of messages.

use super::words;
use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{code, text};
use crate::emit::markdown::number::bytes;
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{Register, RegisterAccess, Telegram};

/// Registers of the controller, and the bytes of messages.
pub(super) fn page(context: &Context<'_>, registers: &[Register], telegrams: &[Telegram]) -> Page {
    let mut page = Page::default();
    page.table(table(context, registers));
    for register in registers.iter().filter(|register| !register.fields.is_empty()) {
        page.heading(4, format!("{} {}", hex(register.address), text(&register.name)));
        page.table(fields(context, "Bit", &register.fields));
    }
    telegrams.iter().for_each(|telegram| message(context, telegram, &mut page));
    page
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

fn message(context: &Context<'_>, telegram: &Telegram, page: &mut Page) {
    let Telegram { id: _, name, address, fields, about, source, origin } = telegram;
    let address = address.map_or(String::new(), |address| format!(" at {}", hex(address)));
    page.heading(3, format!("{}{address}", text(name)));
    page.text(context.paragraphs(about.as_deref()));
    page.table(self::fields(context, "Byte", fields));
    page.text(context.said_line(source.as_ref(), origin));
}

fn fields(context: &Context<'_>, title: &str, fields: &[crate::model::Field]) -> Table {
    words::table(title, fields, |field| words::statements(context, field).join("<br>"))
}
