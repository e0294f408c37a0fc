use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{AxisGroup, Coordinates, Device, Group, Index, Section};

rule! {
    /// The number of a group and the size of all groups give the indices of its parameters. If the manual prints
    /// others, one of the two is wrong, and a master that follows it reads a parameter of another group.
    ///
    /// ## Fires
    /// ```toml
    /// [coordinates]
    /// base = 0x2000
    /// group-size = 512
    ///
    /// [coordinates.groups]
    /// B = { number = 1, range = "0x2400..=0x25FF", name = "Motor" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [coordinates]
    /// base = 0x2000
    /// group-size = 512
    ///
    /// [coordinates.groups]
    /// B = { number = 1, range = "0x2200..=0x23FF", name = "Motor" }
    /// ```
    pub(super) static RULE = "contradicted-group", Values, Warning,
        "the indices of a group are not those of its number";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let Some(coordinates) = &device.coordinates else { return };
    for group in &coordinates.groups {
        let Some(number) = group.number else { continue };
        let path = format!("groups.{}", group.letter);
        if let Some(printed) = group.range {
            compare(device, coordinates, (group, number), (0, printed), &path, report);
        }
        for &AxisGroup { axis, first, last } in &group.per_axis {
            let name = device.axes.get(usize::from(axis)).map_or("?", |axis| axis.name.as_str());
            let path = format!("{path}.per-axis.{name}");
            compare(device, coordinates, (group, number), (axis, (first, last)), &path, report);
        }
    }
}

/// Compares the indices that are printed for a group on an axis with those of its number.
fn compare(
    device: &Device,
    coordinates: &Coordinates,
    (group, number): (&Group, u16),
    (axis, (first, last)): (u8, (Index, Index)),
    path: &str,
    report: &mut Report,
) {
    let size = u32::from(coordinates.group_size);
    let begin = u32::from(coordinates.base.0) + u32::from(number) * size;
    let shift = device
        .arrangement
        .shifts
        .iter()
        .find(|shift| (shift.first.0.into()..=shift.last.0.into()).contains(&begin));
    let distance = shift.map_or(0, |shift| u32::from(shift.by) * u32::from(axis));
    let begin = begin + distance;
    let end = begin + size.saturating_sub(1);
    if (u32::from(first.0), u32::from(last.0)) == (begin, end) {
        return;
    }
    let message = format!(
        "group {} has {first} to {last}, but its number {number} makes 0x{begin:04X} to 0x{end:04X}",
        group.letter
    );
    let far = if distance > 0 { format!(" + 0x{distance:X}") } else { String::new() };
    let formula = format!("{} + {number} × 0x{size:X}{far}", coordinates.base);
    let place = |path: String| coordinates.origin.value(&path);
    let diagnostic = Diagnostic::new(&RULE, message, place(format!("{path}.range")), "as printed")
        .label(place(format!("groups.{}.number", group.letter)), formula);
    report.push(Section::Coordinates.at(path), diagnostic);
}
