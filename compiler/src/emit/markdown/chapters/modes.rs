//! The modes of operation and the changes between them.

use super::states::control;
use super::words::{statements, table};
use crate::emit::markdown::context::{Context, mode_label};
use crate::emit::markdown::inline::{code, link, list, sentence, text};
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{DeviceControl, Fields, HomingBits, Mode, ModeChange, MotionCommand};

/// The modes of operation and the changes between them.
pub(super) fn page(
    context: &Context<'_>,
    modes: &[Mode],
    mode_changes: &[ModeChange],
    control: Option<&DeviceControl>,
) -> Page {
    let mut page = Page::default();
    if modes.is_empty() && mode_changes.is_empty() {
        return page;
    }
    page.table(overview(context, modes));
    modes.iter().for_each(|mode| self::mode(context, mode, &mut page));
    if !mode_changes.is_empty() || control.is_some() {
        page.heading(3, "Changing the mode");
        page.table(changes(context, mode_changes));
        control.iter().for_each(|control| control::modes(context, control, &mut page));
    }
    page
}

fn overview(context: &Context<'_>, modes: &[Mode]) -> Table {
    let titles = ["Code", "Mode", "Short", "Set values", "Bit of 0x6502", "Other codes"];
    Table::of(titles, modes, |mode| {
        [
            code(mode.code),
            link(text(&mode.name), context.mode_id(mode.code)),
            text(&mode.id),
            if mode.cyclic { "every cycle".into() } else { String::new() },
            mode.supported_bit.map_or(String::new(), |bit| bit.to_string()),
            list(mode.aliases.iter().map(code)),
        ]
    })
}

fn mode(context: &Context<'_>, mode: &Mode, page: &mut Page) {
    // What is left out stands in the overview.
    let Mode {
        code,
        about,
        objects,
        control_bits,
        status_bits,
        homing_bits,
        conditions,
        cautions,
        commands,
        source,
        aliases: _,
        id: _,
        name: _,
        cyclic: _,
        supported_bit: _,
        origin,
    } = mode;
    page.place(3, context.mode_id(*code), mode_label(mode));
    page.text(context.paragraphs(about.as_deref()));
    let sentences =
        |lines: &[String]| lines.iter().map(|line| sentence(&context.prose(line))).collect::<Vec<_>>();
    if !cautions.is_empty() {
        let lines = sentences(cautions).into_iter().map(|line| format!("> {}", signalled(&line)));
        page.lines(lines.collect::<Vec<_>>().join("\n"));
    }
    if !conditions.is_empty() {
        page.text("Before it is chosen:");
        page.list(sentences(conditions));
    }
    if !objects.is_empty() {
        let objects = list(objects.iter().map(|address| context.named(*address)));
        page.text(format!("It uses {objects}."));
    }
    page.table(fields(context, "Bit of the controlword", control_bits));
    page.table(fields(context, "Bit of the statusword", status_bits));
    homing_bits.iter().for_each(|bits| page.text(homing(bits)));
    page.table(command_table(context, commands));
    page.text(context.said_line(source.as_ref(), origin));
}

/// The words that say how bad it can get (ISO 3864, ANSI Z535), and one that says that it is nothing bad.
const SIGNALS: [&str; 5] = ["DANGER", "WARNING", "CAUTION", "NOTICE", "Information"];

/// A caution with the word that it begins with set off. It has no box of a kind: what the manual calls a danger would stand
/// below another word.
fn signalled(caution: &str) -> String {
    let signal = SIGNALS.into_iter().find_map(|word| Some((word, caution.strip_prefix(word)?)));
    signal.map_or_else(|| caution.to_owned(), |(word, rest)| format!("**{word}**{rest}"))
}

fn fields(context: &Context<'_>, title: &str, fields: &Fields) -> Table {
    table(title, fields, |field| statements(context, field).join("<br>"))
}

/// By which bits a reference run is started and followed.
fn homing(bits: &HomingBits) -> String {
    let HomingBits { start, reached, attained, error } = bits;
    format!(
        "A rising edge of bit {start} of the controlword starts a reference run. In the statusword, bit {attained} \
         says that the reference is set, bit {error} that the run has failed, and bit {reached} that the axis has come to \
         where it should, or stands."
    )
}

fn command_table(context: &Context<'_>, commands: &[MotionCommand]) -> Table {
    let titles = ["Motion command", "Name", "Chosen by", "What it does", "Controls", "Needs"];
    Table::of(titles, commands, |command| {
        [
            command.code.map_or(String::new(), code),
            text(&command.name),
            context.optional(command.when.as_deref()),
            context.optional(command.about.as_deref()),
            context.optional(command.control.as_deref()),
            list(command.variables.iter().map(|variable| text(variable))),
        ]
    })
}

fn changes(context: &Context<'_>, mode_changes: &[ModeChange]) -> Table {
    let modes = |codes: &[i16]| match codes {
        [] => "any".into(),
        codes => list(codes.iter().map(|code| context.mode(*code))),
    };
    let titles = ["From", "To", "Done when", "Fault when", "Notes", "Source"];
    Table::of(titles, mode_changes, |change| {
        [
            modes(&change.from),
            modes(&change.to),
            context.optional(change.done_when.as_deref()),
            context.optional(change.fault_when.as_deref()),
            context.optional(change.about.as_deref()),
            context.said(change.source.as_ref(), &change.origin),
        ]
    })
}
