//! How the vendor's parameters lie in the dictionary.

use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{code, text};
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{Address, AxisGroup, Coordinates, Group, Index};

/// How numbers of parameters and addresses lead to one another.
pub(super) fn page(context: &Context<'_>, coordinates: &Coordinates) -> Page {
    let mut page = Page::default();
    page.text(context.paragraphs(coordinates.about.as_deref()));
    page.text(format!("> {}", formula(coordinates)));
    let titles = ["Group", "Parameters", "Number", "Indices"];
    page.table(Table::of(titles, &coordinates.groups, |it| group(context, it)));
    page.text(context.said_line(coordinates.source.as_ref(), &coordinates.origin));
    page.titled("By number", by_number(context));
    page
}

/// The vendor's parameters in the order of their numbers, with the objects that they are.
fn by_number(context: &Context<'_>) -> Table {
    let mut rows: Vec<(&str, Address)> = Vec::new();
    for object in context.leading_objects() {
        let whole = object.parameter.as_deref();
        rows.extend(whole.map(|number| (number, Address { index: object.index, subindex: 0 })));
        let entries = object.entries.iter();
        rows.extend(entries.filter_map(|entry| Some((entry.parameter.as_deref()?, entry.address))));
    }
    rows.sort_by_key(|(number, address)| (key(number), *address));
    rows.dedup();
    Table::of(["Parameter", "Object", "Name"], rows, |(number, address)| {
        let name = context.name(address).map_or(String::new(), |name| text(&name));
        [text(number), context.address(address), name]
    })
}

/// What a number is sorted by: its letters, and then what it counts, so that A29 stands before A180, and A619[2] before
/// A619[10].
fn key(number: &str) -> (&str, u32, Option<u32>, &str) {
    let letters = number.find(|c: char| c.is_ascii_digit()).unwrap_or(number.len());
    let (group, rest) = number.split_at(letters);
    let digits = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
    let (line, element) = rest.split_at(digits);
    let index = element.trim_matches(['[', ']']).parse().ok();
    (group, line.parse().unwrap_or(u32::MAX), index, element)
}

/// The formula, with a worked example of the first group that has a number.
fn formula(coordinates: &Coordinates) -> String {
    let base = code(coordinates.base);
    let subindex = match coordinates.element_shift {
        0 => "subindex = element".to_owned(),
        shift => format!("subindex = element + {shift}, or 0 where there are no elements"),
    };
    let size = coordinates.group_size;
    let general = format!("Index = {base} + number of the group × {size} + line; {subindex}.");
    let first = coordinates.groups.iter().find(|group| group.number.is_some());
    let example = first.map(|group| format!("{}1[0]", group.letter));
    let worked = example.and_then(|example| Some((coordinates.address(&example)?, example)));
    match worked {
        Some((address, example)) => format!("{general} So {} is {}.", code(example), code(address)),
        None => general,
    }
}

fn group(context: &Context<'_>, group: &Group) -> [String; 4] {
    let Group { letter, name, number, range, per_axis } = group;
    let span = |first: Index, last: Index| format!("{} to {}", code(first), code(last));
    let others = per_axis.iter().map(|&AxisGroup { axis, first, last }| {
        format!("on {} {}", context.axes(&[axis]), span(first, last))
    });
    let first = range.map(|(first, last)| span(first, last));
    [
        format!("**{}**", text(letter)),
        text(name),
        number.map_or_else(|| "–".into(), |number| number.to_string()),
        first.into_iter().chain(others).collect::<Vec<_>>().join("; "),
    ]
}
