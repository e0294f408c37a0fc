//! The modes of operation and the changes between them.

use serde::Serialize;

use super::words::{statements, table};
use crate::emit::markdown::context::{Context, mode_label};
use crate::emit::markdown::document::{Chapter, Section};
use crate::emit::markdown::inline::{code, link, list, sentence, text};
use crate::emit::markdown::table::Table;
use crate::model::{Mode, ModeBits};

#[derive(Serialize)]
pub(in crate::emit::markdown) struct View {
    overview: Table,
    modes: Vec<ModeView>,
    changes: Table,
}

#[derive(Serialize)]
struct ModeView {
    anchor: String,
    title: String,
    about: String,
    cautions: Vec<String>,
    conditions: Vec<String>,
    objects: String,
    control_bits: Table,
    status_bits: Table,
    commands: Table,
    source: String,
}

impl Chapter for View {
    const ID: &'static str = "modes";
    const TITLE: &'static str = "Modes of operation";
    const TEMPLATE: &'static str = include_str!("../templates/modes.md.j2");

    fn view(context: &Context<'_>) -> Option<Self> {
        let device = context.device;
        (!device.modes.is_empty() || !device.mode_changes.is_empty()).then(|| Self {
            overview: overview(context),
            modes: device.modes.iter().map(|mode| mode_view(context, mode)).collect(),
            changes: changes(context),
        })
    }

    fn sections(&self) -> Vec<Section> {
        let section = |mode: &ModeView| Section { title: mode.title.clone(), anchor: mode.anchor.clone() };
        self.modes.iter().map(section).collect()
    }
}

fn overview(context: &Context<'_>) -> Table {
    let titles = ["Code", "Mode", "Short", "Set values", "Bit of 0x6502", "Other codes"];
    Table::of(titles, &context.device.modes, |mode| {
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

fn mode_view(context: &Context<'_>, mode: &Mode) -> ModeView {
    ModeView {
        anchor: context.mode_id(mode.code),
        title: mode_label(mode),
        about: context.paragraphs(mode.about.as_deref()),
        cautions: mode.cautions.iter().map(|caution| sentence(&context.prose(caution))).collect(),
        conditions: mode.conditions.iter().map(|condition| sentence(&context.prose(condition))).collect(),
        objects: list(mode.objects.iter().map(|address| context.named(*address))),
        control_bits: fields(context, "Bit of the controlword", &mode.control_bits),
        status_bits: fields(context, "Bit of the statusword", &mode.status_bits),
        commands: commands(context, mode),
        source: context.source_line(mode.source.as_ref()),
    }
}

fn fields(context: &Context<'_>, title: &str, mode_bits: &ModeBits) -> Table {
    table(title, &mode_bits.fields, |field| statements(context, field).join("<br>"))
}

fn commands(context: &Context<'_>, mode: &Mode) -> Table {
    let titles = ["Motion command", "Name", "Chosen by", "What it does", "Controls", "Needs"];
    Table::of(titles, &mode.commands, |command| {
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

fn changes(context: &Context<'_>) -> Table {
    let modes = |codes: &[i16]| match codes {
        [] => "any".into(),
        codes => list(codes.iter().map(|code| context.mode(*code))),
    };
    let titles = ["From", "To", "Done when", "Fault when", "Notes", "Source"];
    Table::of(titles, &context.device.mode_changes, |change| {
        [
            modes(&change.from),
            modes(&change.to),
            context.optional(change.done_when.as_deref()),
            context.optional(change.fault_when.as_deref()),
            context.optional(change.about.as_deref()),
            context.source(change.source.as_ref()),
        ]
    })
}
