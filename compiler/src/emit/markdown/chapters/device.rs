//! What the device is and how a master recognises it.

use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{code, link, list, text};
use crate::emit::markdown::number::bytes;
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{Eeprom, Identity, Limit, Role, Source, Translations};
use crate::source::Origin;

/// What is said of a device before anything else.
pub(in crate::emit::markdown) struct Head<'d> {
    pub(super) vendor: &'d str,
    pub(super) about: Option<&'d str>,
    pub(super) models: &'d [String],
    pub(super) group: &'d str,
    pub(super) type_name: &'d str,
    pub(super) profile: Option<u32>,
    pub(super) physics: &'d str,
    pub(super) identity: &'d Identity,
    pub(super) eeprom: &'d Eeprom,
    pub(super) limits: &'d [Limit],
    pub(super) source: Option<&'d Source>,
    pub(super) names: &'d Translations,
    pub(super) ebus_current: Option<i32>,
    pub(super) no_lrw: bool,
    pub(super) url: Option<&'d str>,
    pub(super) urls: &'d Translations,
    pub(super) origin: &'d Origin,
}

/// What the device is and how a master recognises it.
pub(super) fn page(context: &Context<'_>, head: &Head<'_>) -> Page {
    let mut page = Page::default();
    page.text(context.paragraphs(head.about));
    page.table(facts(context, head));
    page.text(context.said_line(head.source, head.origin));
    page.table(identity(head.identity));
    page.text(set_number(head.identity));
    page.text(context.said_line(head.identity.source.as_ref(), &head.identity.origin));
    page.titled("Limits", limits(context, head.limits));
    page
}

fn facts(context: &Context<'_>, head: &Head<'_>) -> Table {
    let names: Vec<String> = context.axis_names().map(text).collect();
    let axes = match context.has_axes() {
        true => format!("{}: {}", link(names.len(), "axes"), list(names)),
        false => String::new(),
    };
    let rows = [
        ("Vendor", text(head.vendor)),
        ("Also called", in_languages(head.names)),
        ("Models", list(head.models.iter().map(|model| text(model)))),
        ("Type", code(head.type_name)),
        ("Group", text(head.group)),
        ("Profile", head.profile.map_or(String::new(), |profile| format!("CiA {profile}"))),
        ("Axes", axes),
        ("Process data", process_data(context)),
        ("Ports", ports(head.physics)),
        ("E-bus", head.ebus_current.map_or(String::new(), current)),
        ("Commands", if head.no_lrw { "LRD and LWR, no LRW".to_owned() } else { String::new() }),
        ("EEPROM", memory(context, head.eeprom)),
        ("Web page", addresses(head)),
    ];
    let rows = rows.into_iter().filter(|(_, value)| !value.is_empty());
    Table::of(["Device", "Facts"], rows, |(name, value)| [name.into(), value])
}

/// A text in other languages, each with its code.
fn in_languages(texts: &Translations) -> String {
    list(texts.iter().map(|it| format!("{} ({})", text(&it.text), it.language)))
}

fn addresses(head: &Head<'_>) -> String {
    let english = head.url.iter().map(|url| text(url));
    let others = (!head.urls.is_empty()).then(|| in_languages(head.urls));
    list(english.chain(others))
}

fn current(milliamperes: i32) -> String {
    match milliamperes {
        0.. => format!("takes {milliamperes} mA"),
        _ => format!("gives {} mA", milliamperes.unsigned_abs()),
    }
}

fn process_data(context: &Context<'_>) -> String {
    let size = |role| bytes(context.device.image_bytes(role));
    if context.device.pdos.is_empty() {
        return String::new();
    }
    let sizes = format!("{} of outputs, {} of inputs", size(Role::Outputs), size(Role::Inputs));
    format!("{} by default", link(sizes, "process-data"))
}

/// What each port is, by the letters of an ESI.
fn ports(physics: &str) -> String {
    let port = |letter| match letter {
        'Y' => "Ethernet (MII)".into(),
        'H' => "Ethernet (MII, fast hot connect)".into(),
        'K' => "E-bus (LVDS)".into(),
        letter => text(&String::from(letter)),
    };
    let ports = physics.chars().filter(|letter| *letter != ' ').map(port);
    list(ports.enumerate().map(|(number, port)| format!("{number}: {port}")))
}

fn memory(context: &Context<'_>, eeprom: &Eeprom) -> String {
    let Eeprom { size, config_data, bootstrap: _, source: _, origin } = eeprom;
    let mark = |key| context.mark(origin, key);
    let config: Vec<String> = config_data.0.iter().map(|byte| format!("{byte:02X}")).collect();
    let begin =
        if config.is_empty() { String::new() } else { format!(", begins with {}", code(config.join(" "))) };
    let begin = if begin.is_empty() { begin } else { begin + &mark("config-data") };
    let area =
        |(address, size): (u16, u16)| format!("{} bytes at {}", size, code(format!("0x{address:04X}")));
    let boot = eeprom.boot_mailbox().map(|areas| areas.map(area));
    let boot = boot.map_or(String::new(), |[out, into]| {
        format!(", mailbox in Bootstrap: {out} out, {into} in") + &mark("bootstrap")
    });
    format!("{}{}{begin}{boot}", bytes(*size), mark("size"))
}

fn limits(context: &Context<'_>, limits: &[Limit]) -> Table {
    Table::of(["Limit", "Figure", "Notes", "Source"], limits, |limit| {
        [
            text(&limit.name),
            context.prose(&limit.value),
            context.optional(limit.about.as_deref()),
            context.said(limit.source.as_ref(), &limit.origin),
        ]
    })
}

/// How a master finds the number that people set at the device.
fn set_number(identity: &Identity) -> String {
    let asked =
        identity.requested_id.then(|| "in the AL status code, when it sets bit 5 of AL control".to_owned());
    let read = identity.id_address.map(|address| format!("at {}", code(format!("0x{address:04X}"))));
    let ways: Vec<String> = asked.into_iter().chain(read).collect();
    match ways.is_empty() {
        true => String::new(),
        false => format!("A master finds the number that people set at the device {}.", ways.join(", or ")),
    }
}

fn identity(identity: &Identity) -> Table {
    let Identity { vendor_id, product_code, revision, serial, replaces, .. } = identity;
    let rows = [
        ("Vendor ID", vendor_id),
        ("Product code", product_code),
        ("Revision number", revision),
        ("Serial number", serial),
    ];
    let replaces = replaces.iter().map(|revision| ("Replaces revision", revision));
    let rows = rows.into_iter().chain(replaces);
    Table::of(["Identity", "Hexadecimal", "Decimal"], rows, |(name, value)| {
        [name.into(), code(format!("{value:#010X}").replace("0X", "0x")), code(value)]
    })
}
