//! Error codes, and the vendor's own codes.

use super::words::value;
use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{anchor, code, link, list, text};
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{DiagnosisMessage, ErrorCode, Index, Meaning, VendorCode};

const ERROR_REGISTER: Index = Index(0x1001);

/// The codes of errors, and what they mean.
pub(super) fn page(
    context: &Context<'_>,
    errors: &[ErrorCode],
    vendor_codes: &[VendorCode],
    diagnosis: &[DiagnosisMessage],
) -> Page {
    let mut page = Page::default();
    if errors.is_empty() && vendor_codes.is_empty() && diagnosis.is_empty() {
        return page;
    }
    let register = context.device.words.iter().find(|word| word.address.index == ERROR_REGISTER);
    if let Some(word) = register {
        let word = link(text(&word.name), context.word_id(&word.id));
        page.text(format!("The bits of the register are those of the {word}."));
    }
    page.table(error_table(context, errors));
    page.titled("Diagnosis messages", message_table(context, diagnosis));
    page.titled("The vendor's own codes", vendor_table(context, vendor_codes));
    page
}

fn error_table(context: &Context<'_>, errors: &[ErrorCode]) -> Table {
    let titles = ["Code", "Error", "Register", "Vendor code", "Meaning", "What to do", "Source"];
    Table::of(titles, errors, |error| {
        let ErrorCode {
            code: _,
            last: _,
            id: _,
            name,
            register,
            vendor_codes,
            about,
            remedy,
            source,
            origin,
        } = error;
        [
            format!("{}{}", anchor(context.error_id(error)), codes(error)),
            format!("**{}**", text(name)),
            register.map_or(String::new(), |register| code(format!("0x{register:02X}"))),
            list(vendor_codes.iter().map(|code| vendor_code(context, *code))),
            context.optional(about.as_deref()),
            context.optional(remedy.as_deref()),
            context.said(source.as_ref(), origin),
        ]
    })
}

/// The messages of the diagnosis history.
fn message_table(context: &Context<'_>, messages: &[DiagnosisMessage]) -> Table {
    let titles = ["Text id", "Message", "Class", "Meaning", "What to do", "Source"];
    Table::of(titles, messages, |message| {
        // The reference is in English.
        let DiagnosisMessage { text_id, text: says, texts: _, class, about, remedy, source, origin } =
            message;
        [
            format!("{}{}", anchor(format!("message-{text_id:04x}")), code(format!("0x{text_id:04X}"))),
            format!("**{}**", text(says)),
            class.map_or(String::new(), |class| text(class.name())),
            context.optional(about.as_deref()),
            context.optional(remedy.as_deref()),
            context.said(source.as_ref(), origin),
        ]
    })
}

/// What a vendor's code means, then what can have caused it.
fn meaning(context: &Context<'_>, about: Option<&str>, causes: &[Meaning]) -> String {
    let about = about.iter().map(|about| context.prose(about));
    let causes = causes.iter().map(|cause| format!("cause {}", value(context, cause)));
    about.chain(causes).collect::<Vec<_>>().join("<br>")
}

fn codes(error: &ErrorCode) -> String {
    let hex = |number: u16| code(format!("0x{number:04X}"));
    if error.is_range() { format!("{} to {}", hex(error.code), hex(error.last)) } else { hex(error.code) }
}

fn vendor_code(context: &Context<'_>, number: u32) -> String {
    let known = context.device.vendor_codes.iter().any(|vendor| vendor.code == number);
    if known { link(code(number), vendor_id(number)) } else { code(number) }
}

fn vendor_id(number: u32) -> String {
    format!("vendor-code-{number}")
}

fn vendor_table(context: &Context<'_>, vendor_codes: &[VendorCode]) -> Table {
    let titles = ["Code", "Name", "Meaning", "Reported as", "Source"];
    Table::of(titles, vendor_codes, |vendor| {
        let VendorCode { code: number, name, about, causes, source, origin } = vendor;
        let errors = context.device.errors.iter().filter(|error| error.vendor_codes.contains(number));
        [
            format!("{}{}", anchor(vendor_id(*number)), code(number)),
            format!("**{}**", text(name)),
            meaning(context, about.as_deref(), causes),
            list(errors.map(|error| link(codes(error), context.error_id(error)))),
            context.said(source.as_ref(), origin),
        ]
    })
}
