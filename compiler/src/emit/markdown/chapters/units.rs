//! What raw numbers mean, with an example that can be checked by hand.

use crate::emit::markdown::context::Context;
use crate::emit::markdown::holds::Holds;
use crate::emit::markdown::inline::{anchor, text};
use crate::emit::markdown::number::{decimal, fraction, grouped};
use crate::emit::markdown::page::Page;
use crate::emit::markdown::table::Table;
use crate::model::{AxisUnit, Path, Scale, Unit};

/// What raw numbers stand for.
pub(super) fn page(context: &Context<'_>, all: &[Unit]) -> Page {
    let titles =
        ["Quantity", "Travels in", "Axes", "Unit", "Raw per unit", "Example", "Factor", "Notes", "Source"];
    let mut units = Table::new(titles);
    for unit in all {
        for (number, (axes, on_axis)) in groups(unit).into_iter().enumerate() {
            // the first row names the quantity, and stands for all
            let holds = if number == 0 { Holds::default() } else { Holds::on_axes(&axes) };
            units.row_for(holds, row(context, unit, number == 0, &axes, on_axis));
        }
    }
    let mut page = Page::default();
    if !units.is_empty() {
        page.text("A raw number, as it travels, is the physical value times the raw steps per unit.");
        page.table(units);
    }
    page
}

/// The axes that share a unit; no axes if all do.
fn groups(unit: &Unit) -> Vec<(Vec<u8>, &AxisUnit)> {
    let mut groups: Vec<(Vec<u8>, &AxisUnit)> = Vec::new();
    for (axis, on_axis) in (0..=u8::MAX).zip(&unit.axes) {
        match groups.iter_mut().find(|(_, same)| *same == on_axis) {
            Some((axes, _)) => axes.push(axis),
            None => groups.push((vec![axis], on_axis)),
        }
    }
    match groups.as_slice() {
        [(_, only)] => vec![(Vec::new(), *only)],
        _ => groups,
    }
}

fn row(context: &Context<'_>, unit: &Unit, first: bool, axes: &[u8], on_axis: &AxisUnit) -> [String; 9] {
    let Unit { id, quantity, axes: _, factor, path, about, source, origin } = unit;
    let AxisUnit { symbol, scale } = on_axis;
    let once = |cell: String| if first { cell } else { String::new() };
    [
        once(format!("{}**{}**", anchor(format!("unit-{id}")), text(quantity))),
        once(path.map_or("", travel).into()),
        if axes.is_empty() { String::new() } else { context.axis_range(axes) },
        text(symbol),
        scale.map_or_else(|| "1".into(), one_unit),
        scale.map_or(String::new(), |scale| example(scale, symbol)),
        once(factor.map_or(String::new(), |address| context.address(address))),
        once(context.optional(about.as_deref())),
        context.said(source.as_ref(), origin),
    ]
}

fn travel(path: Path) -> &'static str {
    match path {
        Path::Pdo => "process data",
        Path::Sdo => "SDOs",
    }
}

fn one_unit(scale: Scale) -> String {
    match decimal(scale.raw.into(), scale.units.into()) {
        Some(whole) if !whole.contains('.') => whole.parse().map_or(whole, grouped),
        Some(number) => number,
        None => format!("{} / {}", grouped(scale.raw.into()), grouped(scale.units.into())),
    }
}

/// A physical value that comes out as a whole raw number, as near to 12.5 as there is one.
fn example(scale: Scale, symbol: &str) -> String {
    let (raw, units) = (u128::from(scale.raw), u128::from(scale.units));
    let halves = 25 * raw;
    let (physical, number) = match halves.checked_rem(2 * units) {
        Some(0) => ("12.5".to_owned(), halves / (2 * units)),
        _ => (fraction(units, 1), raw),
    };
    let number = i128::try_from(number).map_or_else(|_| number.to_string(), grouped);
    format!("{physical} {} ↔ {number}", text(symbol))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn examples_are_whole_raw_numbers() {
        assert_eq!(example(Scale { raw: 100_000, units: 1 }, "mm"), "12.5 mm ↔ 1\u{202F}250\u{202F}000");
        assert_eq!(example(Scale { raw: 1, units: 1 }, "µm"), "1 µm ↔ 1");
        assert_eq!(example(Scale { raw: 4, units: 3 }, "rpm"), "3 rpm ↔ 4");
    }

    #[test]
    fn a_unit_is_so_many_raw_steps() {
        assert_eq!(one_unit(Scale { raw: 100_000, units: 1 }), "100\u{202F}000");
        assert_eq!(one_unit(Scale { raw: 5, units: 2 }), "2.5");
        assert_eq!(one_unit(Scale { raw: 4, units: 3 }), "4 / 3");
    }
}
