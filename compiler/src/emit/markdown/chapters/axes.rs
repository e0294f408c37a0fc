//! The axes and where each has its objects.

use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{code, list, text};
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{Arrangement, Axis, Index, Module, Shift, Slot};

/// Which axes there are, and what moves from one to the next.
pub(super) fn page(
    context: &Context<'_>,
    axes: &[Axis],
    arrangement: &Arrangement,
    (modules, slots): (&[Module], &[Slot]),
) -> Page {
    let Arrangement { shifts, pdo_shift, add_info, coupling, source, origin } = arrangement;
    let mut page = Page::default();
    let about = axes.iter().any(|axis| axis.about.is_some());
    if context.has_axes() || coupling.is_some() || about {
        page.text(context.paragraphs(coupling.as_deref()));
        page.table(table(context, axes, shifts));
        rules(context, shifts, *pdo_shift).iter().for_each(|rule| page.text(rule));
        add_info.iter().for_each(|add_info| page.text(kind(*add_info)));
        page.text(context.said_line(source.as_ref(), origin));
        page.titled("Modules", module_table(context, modules));
    }
    page.titled("Slots", slot_table(context, slots));
    page
}

fn table(context: &Context<'_>, axes: &[Axis], shifts: &[Shift]) -> Table {
    Table::of(["No.", "Axis", "Motion", "Objects", "PDOs"], axes, |axis| {
        let Axis { number, name, about } = axis;
        [
            (u16::from(*number) + 1).to_string(),
            format!("**{}**", text(name)),
            context.optional(about.as_deref()),
            list(shifts.iter().map(|shift| range_of(axis, shift))),
            pdos(context, axis),
        ]
    })
}

fn range_of(axis: &Axis, shift: &Shift) -> String {
    let at = |index: Index| Index(index.0.saturating_add(shift.by.saturating_mul(axis.number.into())));
    format!("{} to {}", code(at(shift.first)), code(at(shift.last)))
}

fn pdos(context: &Context<'_>, axis: &Axis) -> String {
    let own = context.device.pdos.iter().filter(|pdo| pdo.axis == Some(axis.number));
    list(own.map(|pdo| code(pdo.index)))
}

/// What is in the slots, where the ESI has some.
fn module_table(context: &Context<'_>, modules: &[Module]) -> Table {
    Table::of(["Module", "Name", "In the slots of", "Source"], modules, |module| {
        [
            code(format!("0x{:08X}", module.ident)),
            text(&module.name),
            list(context.device.axes_of(module).map(|axis| text(&axis.name))),
            context.said(module.source.as_ref(), &module.origin),
        ]
    })
}

/// Places for modules.
fn slot_table(context: &Context<'_>, slots: &[Slot]) -> Table {
    Table::of(["Slots", "How many", "Modules that fit", "Source"], slots, |slot| {
        let ident = |ident: &u32| match slot.default == Some(*ident) {
            true => format!("{} (default)", code(format!("0x{ident:08X}"))),
            false => code(format!("0x{ident:08X}")),
        };
        let classes = slot.classes.iter().map(|it| text(it.name.as_ref().unwrap_or(&it.class)));
        [
            text(&slot.name),
            if slot.min == slot.max { slot.max.to_string() } else { format!("{} to {}", slot.min, slot.max) },
            list(slot.modules.iter().map(ident).chain(classes)),
            context.said(slot.source.as_ref(), &slot.origin),
        ]
    })
}

/// What each axis is, by the bits of the device type.
fn kind(add_info: u16) -> String {
    let name = match add_info {
        1 => " (frequency converter)",
        2 => " (servo drive)",
        4 => " (stepper motor)",
        _ => "",
    };
    format!("Each axis is of type {}{name}.", code(add_info))
}

fn rules(context: &Context<'_>, shifts: &[Shift], pdo_shift: u16) -> Vec<String> {
    let device = context.device;
    if !context.has_axes() {
        return Vec::new();
    }
    let first = device.axes.first().map_or("", |axis| axis.name.as_str());
    let objects = shifts.iter().map(|shift| {
        let (from, to) = (code(shift.first), code(shift.last));
        format!("objects {from} to {to} by {}", code(format!("{:#X}", shift.by).replace("0X", "0x")))
    });
    let pdos = format!("PDOs by {}", code(format!("{:#X}", pdo_shift).replace("0X", "0x")));
    let has_pdos = device.pdos.iter().any(|pdo| pdo.axis.is_some());
    let moved = objects.chain(has_pdos.then_some(pdos));
    vec![format!(
        "Whatever exists once for each axis is described for axis {}. From an axis to the next move {}.",
        text(first),
        moved.collect::<Vec<_>>().join(", and ")
    )]
}
