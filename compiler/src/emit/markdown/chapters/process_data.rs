//! The process data objects and how their bytes are laid out.

use serde::Serialize;

use crate::emit::markdown::chapter::{Chapter, Section};
use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{code, list, text};
use crate::emit::markdown::number::{bytes, place, width};
use crate::emit::markdown::table::Table;
use crate::model::{Address, Direction, Mapped, Pdo, Role};

#[derive(Serialize)]
pub(in crate::emit::markdown) struct View {
    directions: Vec<DirectionView>,
}

#[derive(Serialize)]
struct DirectionView {
    title: &'static str,
    anchor: &'static str,
    overview: Table,
    image_size: String,
    image: Table,
    pdos: Vec<PdoView>,
}

#[derive(Serialize)]
struct PdoView {
    anchor: String,
    index: String,
    name: String,
    about: String,
    facts: String,
    layout: Table,
    source: String,
}

impl Chapter for View {
    type Parts<'d> = &'d [Pdo];

    const ID: &'static str = "process-data";
    const TITLE: &'static str = "Process data";
    const TEMPLATE: &'static str = include_str!("../templates/process_data.md.j2");

    fn view(context: &Context<'_>, pdos: Self::Parts<'_>) -> Option<Self> {
        let directions = [(Direction::Rx, Role::Outputs), (Direction::Tx, Role::Inputs)];
        let directions = directions.into_iter().filter_map(|(way, role)| direction(context, way, role));
        let directions: Vec<DirectionView> = directions.collect();
        (!pdos.is_empty()).then_some(Self { directions })
    }

    fn sections(&self) -> Vec<Section> {
        let section = |way: &DirectionView| Section { title: way.title.into(), anchor: way.anchor.into() };
        self.directions.iter().map(section).collect()
    }
}

fn direction(context: &Context<'_>, way: Direction, role: Role) -> Option<DirectionView> {
    let (id, title) = match way {
        Direction::Rx => ("outputs", "Outputs: from the master to the device"),
        Direction::Tx => ("inputs", "Inputs: from the device to the master"),
    };
    let pdos: Vec<&Pdo> = context.leading_pdos().filter(|pdo| pdo.direction == way).collect();
    (!pdos.is_empty()).then(|| DirectionView {
        title,
        anchor: id,
        overview: overview(context, &pdos),
        image_size: bytes(context.device.image_bytes(role)),
        image: image(context, role),
        pdos: pdos.iter().map(|pdo| pdo_view(context, pdo)).collect(),
    })
}

/// A line for each PDO, with its index on the other axes.
fn overview(context: &Context<'_>, pdos: &[&Pdo]) -> Table {
    let axes = context.axis_names().skip(1).map(|name| format!("on {}", text(name)));
    let titles = ["PDO", "Name", "Size", "Mode", "Not with"].map(String::from);
    let mut table = Table::new(titles.into_iter().chain(axes));
    for pdo in pdos {
        let others = context.pdo_on_axes(pdo).into_iter().skip(1);
        let others = others.map(|other| other.map_or(String::new(), |other| code(other.index)));
        let cells = [
            context.index(pdo.index),
            text(&pdo.name),
            width(pdo.bits()),
            pdo.mode.map_or(String::new(), |mode| context.mode_code(mode)),
            list(pdo.excludes.iter().map(|other| context.index(*other))),
        ];
        table.row(cells.into_iter().chain(others));
    }
    table
}

/// Where each PDO of the default assignment lies in the process image.
fn image(context: &Context<'_>, role: Role) -> Table {
    let mut table = Table::new(["Bytes", "PDO", "Name", "Axis"]);
    let mut offset = 0;
    for pdo in context.device.assigned(role) {
        let axis = pdo.axis.and_then(|axis| context.device.axes.get(usize::from(axis)));
        table.row([
            place(offset, pdo.bits()),
            context.index(pdo.index),
            text(&pdo.name),
            axis.filter(|_| context.has_axes()).map_or(String::new(), |axis| text(&axis.name)),
        ]);
        offset += pdo.bits();
    }
    table
}

fn pdo_view(context: &Context<'_>, pdo: &Pdo) -> PdoView {
    PdoView {
        anchor: context.pdo_id(pdo),
        index: code(pdo.index),
        name: text(&pdo.name),
        about: context.paragraphs(pdo.about.as_deref()),
        facts: facts(context, pdo).join(" · "),
        layout: layout(context, pdo),
        source: context.said_line(pdo.source.as_ref(), &pdo.origin),
    }
}

/// What is to be said of a PDO beyond the overview, its layout and what else its view shows.
fn facts(context: &Context<'_>, pdo: &Pdo) -> Vec<String> {
    let Pdo {
        index,
        leading: _,
        mandatory,
        fixed,
        max_bytes,
        max_entries,
        mode,
        total,
        direction: _,
        name: _,
        axis: _,
        entries: _,
        excludes: _,
        about: _,
        source: _,
        sync_unit,
        origin: _,
    } = pdo;
    let assigned = context.device.sync_managers.iter().any(|manager| manager.pdos.contains(index));
    let claimed = total.filter(|total| u32::from(*total) != pdo.bytes());
    let facts = [
        Some(format!("**{}**", width(pdo.bits()))),
        assigned.then(|| "assigned by default".into()),
        mandatory.then(|| "cannot be taken out".into()),
        fixed.then(|| "fixed mapping".into()),
        max_bytes.map(|most| format!("can be mapped up to {}", bytes(most.into()))),
        max_entries.map(|most| format!("up to {most} entries")),
        mode.map(|mode| format!("for mode {}", context.mode(mode))),
        sync_unit.as_deref().map(|unit| format!("sync unit {}", text(unit))),
        claimed.map(|total| format!("the manual gives {}", bytes(total.into()))),
    ];
    facts.into_iter().flatten().collect()
}

/// The bytes of a PDO.
pub(super) fn layout(context: &Context<'_>, pdo: &Pdo) -> Table {
    let titles = ["Bytes", "Object", "Name", "Type", "Unit", "Mapping entry"];
    Table::of(titles, &pdo.entries, |mapped| {
        [
            place(mapped.offset, mapped.bits),
            mapped.address.map_or(String::new(), |address| context.address(address)),
            name(context, mapped),
            mapped.data_type.map_or_else(|| width(mapped.bits), |data_type| data_type.to_string()),
            unit(context, mapped),
            mapping_entry(mapped),
        ]
    })
}

fn name(context: &Context<'_>, mapped: &Mapped) -> String {
    match mapped.address {
        None => "*padding*".into(),
        Some(address) if context.device.entry(address).is_none() => {
            format!("{} *(not in the dictionary)*", text(&mapped.name))
        }
        Some(_) => text(&mapped.name),
    }
}

fn unit(context: &Context<'_>, mapped: &Mapped) -> String {
    let entry = mapped.address.and_then(|address| context.device.entry(address));
    entry.map_or(String::new(), |entry| context.unit(entry))
}

/// The value of the mapping object's entry: index, subindex and width in bits.
fn mapping_entry(mapped: &Mapped) -> String {
    let (index, subindex) = mapped.address.map_or((0, 0), |Address { index, subindex }| (index.0, subindex));
    code(format!("0x{index:04X}{subindex:02X}{:02X}", mapped.bits))
}
