//! Choices of process data and mode, with what a master writes to bring them about.

use super::process_data::layout;
use crate::emit::markdown::context::Context;
use crate::emit::markdown::holds::Holds;
use crate::emit::markdown::inline::{code, fragment, list, text};
use crate::emit::markdown::number::{duration, width};
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{Configuration, Index};

/// Choices of process data and mode, with what a master writes to bring them about.
pub(super) fn page(context: &Context<'_>, configurations: &[Configuration]) -> Page {
    let mut page = Page::default();
    configurations.iter().for_each(|one| configuration(context, one, &mut page));
    page
}

fn configuration(context: &Context<'_>, configuration: &Configuration, page: &mut Page) {
    let Configuration {
        id,
        name,
        default: _,
        mapping,
        about,
        source,
        outputs: _,
        inputs: _,
        mode: _,
        cycle_time: _,
        writes: _,
        startup: _,
        origin,
    } = configuration;
    page.place(3, fragment(format!("configuration-{id}")), text(name));
    page.text(context.paragraphs(about.as_deref()));
    page.list(facts(context, configuration));
    for pdo in mapping {
        let (index, size) = (context.index(pdo.index), width(pdo.bits()));
        page.text(format!("{index} {}, mapped anew to {size}:", text(&pdo.name)));
        page.table(layout(context, pdo));
    }
    if !configuration.startup.is_empty() {
        page.text("What the master writes through the mailbox:");
        page.table(startup(context, configuration));
    }
    page.text(context.said_line(source.as_ref(), origin));
}

fn facts(context: &Context<'_>, configuration: &Configuration) -> Vec<String> {
    let pdos = |title: &str, pdos: &Option<Vec<Index>>| {
        pdos.as_ref().map(|pdos| match pdos.as_slice() {
            [] => format!("{title}: none"),
            pdos => format!("{title}: {}", list(pdos.iter().map(|pdo| context.index(*pdo)))),
        })
    };
    let facts = [
        configuration.default.then(|| "The default of an ESI".to_owned()),
        configuration.mode.map(|mode| format!("Mode: {}", context.mode(mode))),
        configuration.cycle_time.map(|time| format!("Cycle time: {}", duration(time.0))),
        pdos("Outputs", &configuration.outputs),
        pdos("Inputs", &configuration.inputs),
    ];
    facts.into_iter().flatten().collect()
}

fn startup(context: &Context<'_>, configuration: &Configuration) -> Table {
    let mut table = Table::new(["No.", "During", "Object", "Bytes in order", "What for"]);
    for (write, number) in configuration.startup.iter().zip(1..) {
        let bytes: Vec<String> = write.data.iter().map(|byte| format!("{byte:02X}")).collect();
        let axis = context.device.object(write.address.index).and_then(|object| object.axis);
        let row = [
            number.to_string(),
            code(&write.transition),
            context.exact(write.address),
            code(bytes.join(" ")),
            context.prose(&write.comment),
        ];
        table.row_for(axis.map_or_else(Holds::default, |axis| Holds::on_axes(&[axis])), row);
    }
    table
}
