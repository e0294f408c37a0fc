//! The modes of operation and the changes between them.

use serde::Serialize;

use super::states::control;
use super::words::{statements, table};
use crate::emit::markdown::chapter::{Chapter, Section};
use crate::emit::markdown::context::{Context, mode_label};
use crate::emit::markdown::inline::{code, link, list, sentence, text};
use crate::emit::markdown::table::Table;
use crate::model::{DeviceControl, Fields, HomingBits, Mode, ModeChange, MotionCommand};

#[derive(Serialize)]
pub(in crate::emit::markdown) struct View {
    overview: Table,
    modes: Vec<ModeView>,
    changes: Table,
    control: String,
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
    homing: String,
    commands: Table,
    source: String,
}

impl Chapter for View {
    type Parts<'d> = (&'d [Mode], &'d [ModeChange], Option<&'d DeviceControl>);

    const ID: &'static str = "modes";
    const TITLE: &'static str = "Modes of operation";
    const TEMPLATE: &'static str = include_str!("../templates/modes.md.j2");

    fn view(context: &Context<'_>, (modes, mode_changes, control): Self::Parts<'_>) -> Option<Self> {
        (!modes.is_empty() || !mode_changes.is_empty()).then(|| Self {
            overview: overview(context, modes),
            modes: modes.iter().map(|mode| mode_view(context, mode)).collect(),
            changes: changes(context, mode_changes),
            control: control.map_or(String::new(), |control| control::modes(context, control)),
        })
    }

    fn sections(&self) -> Vec<Section> {
        let section = |mode: &ModeView| Section { title: mode.title.clone(), anchor: mode.anchor.clone() };
        self.modes.iter().map(section).collect()
    }
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

fn mode_view(context: &Context<'_>, mode: &Mode) -> ModeView {
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
    let sentences = |lines: &[String]| lines.iter().map(|line| sentence(&context.prose(line))).collect();
    ModeView {
        anchor: context.mode_id(*code),
        title: mode_label(mode),
        about: context.paragraphs(about.as_deref()),
        cautions: sentences(cautions),
        conditions: sentences(conditions),
        objects: list(objects.iter().map(|address| context.named(*address))),
        control_bits: fields(context, "Bit of the controlword", control_bits),
        status_bits: fields(context, "Bit of the statusword", status_bits),
        homing: homing_bits.as_ref().map_or(String::new(), homing),
        commands: command_table(context, commands),
        source: context.said_line(source.as_ref(), origin),
    }
}

fn fields(context: &Context<'_>, title: &str, fields: &Fields) -> Table {
    table(title, fields, |field| statements(context, field).join("<br>"))
}

/// By which bits a reference run is started and followed.
fn homing(bits: &HomingBits) -> String {
    let HomingBits { start, reached, attained, error } = bits;
    format!(
        "A rising edge of bit {start} of the controlword starts a reference run. In the statusword, bit {attained} \
         says that the reference is set, bit {error} that the run has failed, and bit {reached} that it is over."
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
