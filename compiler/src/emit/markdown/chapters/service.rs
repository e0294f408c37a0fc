//! What a person sets, in the device and in the master, and in which order.

use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{anchor, code, fragment, sentence, text};
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{
    Address, Effective, Kind, MasterSetting, Parameter, Procedure, Step, Stored, Value, ValueRange,
};

/// What is set in the master, parameters that are no objects, and procedures step by step.
pub(super) fn page(
    context: &Context<'_>,
    settings: &[MasterSetting],
    parameters: &[Parameter],
    procedures: &[Procedure],
) -> Page {
    let mut page = Page::default();
    page.titled("In the master", master_settings(context, settings));
    page.titled("Parameters outside the object dictionary", parameter_table(context, parameters));
    procedures.iter().for_each(|procedure| self::procedure(context, procedure, &mut page));
    page
}

fn master_settings(context: &Context<'_>, settings: &[MasterSetting]) -> Table {
    let titles = ["Setting", "Value", "For", "Why", "Source"];
    Table::of(titles, settings, |setting| {
        [
            format!("**{}**", text(&setting.name)),
            context.prose(&setting.value),
            if setting.per_axis { "each axis".into() } else { String::new() },
            context.optional(setting.about.as_deref()),
            context.said(setting.source.as_ref(), &setting.origin),
        ]
    })
}

fn parameter_table(context: &Context<'_>, parameters: &[Parameter]) -> Table {
    let titles = ["Parameter", "Name", "Object", "On delivery", "Range", "Unit", "What it does", "Source"];
    Table::of(titles, parameters, |parameter| {
        let Parameter {
            id,
            name,
            address,
            kind,
            elements,
            about,
            default,
            min,
            max,
            symbol,
            values,
            effective,
            stored,
            source,
            origin,
        } = parameter;
        let made = made_of(*kind, *elements);
        let kept = [effective.map(Effective::sentence), stored.map(Stored::sentence)];
        let kept = kept.into_iter().flatten().map(str::to_owned);
        [
            format!("{}{}", anchor(context.parameter_id(parameter)), code(id)),
            format!("**{}**", text(name)),
            address.map_or(String::new(), |address| place(context, parameter, address)),
            default.as_ref().map_or(String::new(), code),
            range(min.as_ref(), max.as_ref()),
            symbol.as_deref().map_or(String::new(), text),
            effect(context, about.as_deref(), made.into_iter().chain(kept), values),
            context.said(source.as_ref(), origin),
        ]
    })
}

fn range(min: Option<&Value>, max: Option<&Value>) -> String {
    match (min, max) {
        (Some(min), Some(max)) => format!("{} to {}", code(min), code(max)),
        (Some(min), None) => format!("{} or more", code(min)),
        (None, Some(max)) => format!("up to {}", code(max)),
        (None, None) => String::new(),
    }
}

/// Where a parameter lies: at one address, or with its elements at several.
fn place(context: &Context<'_>, parameter: &Parameter, first: Address) -> String {
    let place = context.exact(first);
    let last = parameter.elements.and_then(|count| first.subindex.checked_add(count.checked_sub(1)?));
    match last {
        Some(last) if last != first.subindex => format!("{place} to {}", code(format!(":{last:02X}"))),
        None if parameter.has_elements() => format!("from {place} on"),
        _ => place,
    }
}

/// That it is a single value, or how many elements it has.
fn made_of(kind: Option<Kind>, elements: Option<u8>) -> Option<String> {
    let kind = kind.map(|kind| match kind {
        Kind::Var => "a single value",
        Kind::Array => "an array",
        Kind::Record => "a record",
    });
    let elements =
        elements.map(|count| format!("{count} {}", if count == 1 { "element" } else { "elements" }));
    match (kind, elements) {
        (Some(kind), Some(elements)) => Some(format!("{kind} of {elements}")),
        (kind, elements) => elements.or_else(|| kind.map(str::to_owned)),
    }
}

fn effect(
    context: &Context<'_>,
    about: Option<&str>,
    said: impl Iterator<Item = String>,
    values: &[ValueRange],
) -> String {
    let about = about.iter().map(|about| context.prose(about));
    let values = values.iter().map(|range| range_meaning(context, range));
    about.chain(said.map(|said| sentence(&said))).chain(values).collect::<Vec<_>>().join("<br>")
}

/// A value, or a range of values, with what it means.
fn range_meaning(context: &Context<'_>, range: &ValueRange) -> String {
    let about = range.about.as_ref().map_or(String::new(), |about| format!(": {}", context.prose(about)));
    let number = |number| code(range.notation.written(number));
    let numbers = if range.first == range.last {
        number(range.first)
    } else {
        format!("{} to {}", number(range.first), number(range.last))
    };
    format!("{numbers} {}{about}", text(&range.name))
}

fn procedure(context: &Context<'_>, procedure: &Procedure, page: &mut Page) {
    page.place(3, fragment(format!("procedure-{}", procedure.id)), text(&procedure.name));
    page.text(context.paragraphs(procedure.about.as_deref()));
    let steps: Vec<String> = procedure.steps.iter().map(|one| step(context, one)).collect();
    page.steps(&steps);
    page.text(context.said_line(procedure.source.as_ref(), &procedure.origin));
}

fn step(context: &Context<'_>, step: &Step) -> String {
    let text = sentence(&context.prose(&step.text));
    match (step.address, &step.write) {
        (Some(address), Some(value)) => {
            format!("{text} Write {} to {}.", written(context, address, value), context.named(address))
        }
        (Some(address), None) => format!("{text} See {}.", context.named(address)),
        (None, Some(value)) => format!("{text} Write {}.", code(value)),
        (None, None) => text,
    }
}

/// A value as one writes it to an entry.
fn written(context: &Context<'_>, address: Address, value: &Value) -> String {
    context.device.entry(address).map_or_else(|| code(value), |entry| context.value(entry, value))
}
