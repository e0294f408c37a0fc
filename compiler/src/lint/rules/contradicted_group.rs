use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Index};

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
    let size = u32::from(coordinates.group_size);
    for group in &coordinates.groups {
        let (Some(number), Some((first, last))) = (group.number, group.range) else { continue };
        let begin = u32::from(coordinates.base.0) + u32::from(number) * size;
        let end = begin + size.saturating_sub(1);
        if (u32::from(first.0), u32::from(last.0)) == (begin, end) {
            continue;
        }
        let path = format!("groups.{}", group.letter);
        let message = format!(
            "group {} has {first} to {last}, but its number {number} makes 0x{begin:04X} to 0x{end:04X}",
            group.letter
        );
        let place = |key: &str| coordinates.origin.value(&format!("{path}.{key}"));
        let diagnostic = Diagnostic::new(&RULE, message, place("range"), "as printed")
            .label(place("number"), format!("{} + {number} × 0x{size:X}", Index(coordinates.base.0)));
        report.push(format!("coordinates.{path}"), diagnostic);
    }
}
