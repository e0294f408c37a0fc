//! The process data objects and how their bytes are laid out.

use super::objects::of_mapping;
use crate::emit::markdown::context::Context;
use crate::emit::markdown::holds::Holds;
use crate::emit::markdown::inline::{code, list, text};
use crate::emit::markdown::number::{bytes, place, width};
use crate::emit::markdown::page::Page;
use crate::emit::markdown::picture;
use crate::emit::markdown::table::{Table, Title};
use crate::model::{Address, Direction, Mapped, Oversampling, Pdo, Provenance, Role, provenance};

/// The process data objects and how their bytes are laid out.
pub(super) fn page(context: &Context<'_>) -> Page {
    let mut page = Page::default();
    direction(context, Direction::Rx, Role::Outputs, &mut page);
    direction(context, Direction::Tx, Role::Inputs, &mut page);
    page
}

fn direction(context: &Context<'_>, way: Direction, role: Role, page: &mut Page) {
    let pdos: Vec<&Pdo> = context.leading_pdos().filter(|pdo| pdo.direction == way).collect();
    if pdos.is_empty() {
        return;
    }
    match way {
        Direction::Rx => page.place(3, "outputs", "Outputs: from the master to the device"),
        Direction::Tx => page.place(3, "inputs", "Inputs: from the device to the master"),
    }
    page.table(overview(context, &pdos));
    let image = image(context, role);
    if !image.is_empty() {
        let size = bytes(context.device.image_bytes(role));
        page.text(format!("The default assignment makes an image of {size}:"));
        page.table(image);
    }
    pdos.iter().for_each(|pdo| self::pdo(context, pdo, page));
}

/// A line for each PDO, with its index on the other axes.
fn overview(context: &Context<'_>, pdos: &[&Pdo]) -> Table {
    let titles = ["PDO", "Name", "Size", "Mode", "Not with"].map(Title::from);
    let mut table = Table::new(titles.into_iter().chain(context.axis_titles("on").skip(1)));
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
        let holds = pdo.axis.map_or_else(Holds::default, |axis| Holds::on_axes(&[axis]));
        let row = [
            place(offset, pdo.bits()),
            context.index(pdo.index),
            text(&pdo.name),
            axis.filter(|_| context.has_axes()).map_or(String::new(), |axis| text(&axis.name)),
        ];
        table.row_for(holds, row);
        offset += pdo.bits();
    }
    table
}

fn pdo(context: &Context<'_>, pdo: &Pdo, page: &mut Page) {
    page.place(4, context.pdo_id(pdo), format!("{} {}", code(pdo.index), text(&pdo.name)));
    page.text(context.paragraphs(pdo.about.as_deref()));
    page.text(facts(context, pdo).join(" · "));
    context.picture(page, || picture::bytes(pdo));
    page.table(layout(context, pdo));
    context.device.object(pdo.index).iter().for_each(|object| of_mapping(context, object, page));
    page.text(context.said_line(pdo.source.as_ref(), &pdo.origin));
}

/// What is to be said of a PDO beyond the overview, its layout and what else is shown of it.
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
        names: _,
        axis: _,
        entries: _,
        excludes: _,
        about: _,
        source: _,
        sync_unit,
        r#virtual,
        oversampling,
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
        r#virtual.then(|| "for a master's own programs only".into()),
        oversampling.map(samples),
        claimed.map(|total| format!("the manual gives {}", bytes(total.into()))),
    ];
    facts.into_iter().flatten().collect()
}

/// How often its values can be there in a cycle.
fn samples(oversampling: Oversampling) -> String {
    let Oversampling { factor, min, max, step: _ } = oversampling;
    let least = min.unwrap_or(1);
    let most = max.map_or(String::new(), |max| format!(" of {least} to {max}"));
    format!("{factor}{most} times in a cycle")
}

/// The bytes of a PDO.
pub(super) fn layout(context: &Context<'_>, pdo: &Pdo) -> Table {
    let titles = ["Bytes", "Object", "Name", "Type", "Unit", "Mapping entry"];
    Table::of(titles, &pdo.entries, |mapped| {
        [
            place(mapped.offset, mapped.bits),
            mapped.address.map_or(String::new(), |address| context.address(address)),
            name(context, mapped) + &answered(context, mapped),
            mapped.data_type.map_or_else(|| width(mapped.bits), |data_type| data_type.to_string()),
            unit(context, mapped),
            mapping_entry(mapped),
        ]
    })
}

/// What errata have to say of an entry. Whether the whole list is assumed is said below it.
fn answered(context: &Context<'_>, mapped: &Mapped) -> String {
    let is_answered = |key: &&str| {
        matches!(provenance(&mapped.origin, key), Provenance::Corrected(_) | Provenance::Contradicted(_))
    };
    let keys: Vec<&str> =
        ["entry", "name", "bits", "type", "about"].into_iter().filter(is_answered).collect();
    context.marks(&mapped.origin, &keys)
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
