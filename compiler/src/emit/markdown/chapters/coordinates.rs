//! How the vendor's parameters lie in the dictionary.

use crate::emit::markdown::context::Context;
use crate::emit::markdown::inline::{code, text};
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{AxisGroup, Coordinates, Group, Index};

/// How numbers of parameters and addresses lead to one another.
pub(super) fn page(context: &Context<'_>, coordinates: &Coordinates) -> Page {
    let mut page = Page::default();
    page.text(context.paragraphs(coordinates.about.as_deref()));
    page.text(format!("> {}", formula(coordinates)));
    if coordinates.info_shift > 0 {
        page.text(format!("SDO information counts subindices from {} on.", coordinates.info_shift));
    }
    let titles = ["Group", "Parameters", "Number", "Indices"];
    page.table(Table::of(titles, &coordinates.groups, |it| group(context, it)));
    page.text(context.said_line(coordinates.source.as_ref(), &coordinates.origin));
    page
}

/// The formula, with a worked example of the first group that has a number.
fn formula(coordinates: &Coordinates) -> String {
    let base = code(coordinates.base);
    let general = format!(
        "Index = {base} + number of the group × {} + line; subindex = element.",
        coordinates.group_size
    );
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
