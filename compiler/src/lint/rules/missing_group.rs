use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Coordinates, Device, Place, Section};
use crate::source::Location;

rule! {
    /// Where a vendor numbers parameters by group and line, the group is what leads to the index. A parameter of a
    /// group that is not listed is a misprint, or the list lacks the group.
    ///
    /// ## Fires
    /// ```toml
    /// [coordinates]
    /// base = 0x2000
    /// group-size = 512
    /// groups = { A = { number = 0, name = "Drive" } }
    ///
    /// [parameters]
    /// A09 = { name = "Restart" }
    /// W10 = { name = "Warning" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [coordinates]
    /// base = 0x2000
    /// group-size = 512
    /// groups = { A = { number = 0, name = "Drive" } }
    ///
    /// [parameters]
    /// A09 = { name = "Restart" }
    /// A10 = { name = "Warning" }
    /// ```
    pub(super) static RULE = "missing-group", Values, Warning,
        "a parameter belongs to a group that is not listed";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let Some(coordinates) = &device.coordinates else { return };
    let letters: BTreeSet<&str> = coordinates.groups.iter().map(|group| group.letter.as_str()).collect();
    let known = (coordinates, &letters);
    for parameter in &device.parameters {
        let at = Section::Parameters.at(&parameter.id);
        judge(known, &parameter.id, at, parameter.origin.header(), report);
    }
    for entry in device.objects.iter().flat_map(|object| &object.entries) {
        if let Some(parameter) = &entry.parameter {
            judge(known, parameter, entry.address.into(), entry.origin.value("parameter"), report);
        }
    }
}

fn judge(
    (coordinates, letters): (&Coordinates, &BTreeSet<&str>),
    parameter: &str,
    at: Place,
    place: Location,
    report: &mut Report,
) {
    let Some(letter) = group_of(parameter) else { return };
    if letters.contains(letter) {
        return;
    }
    let message = format!("{parameter} belongs to group {letter}, which is not listed");
    let diagnostic = Diagnostic::new(&RULE, message, place, format!("group {letter}"))
        .label(coordinates.origin.value("groups"), "the groups")
        .help("list it there, with its number");
    report.push(at, diagnostic);
}

/// The letter of a coordinate: `E` of `E200` and of `E200[0]`; none for a name that is no coordinate.
fn group_of(parameter: &str) -> Option<&str> {
    let letter = parameter.get(..1).filter(|letter| letter.chars().all(|c| c.is_ascii_uppercase()))?;
    let line = parameter.get(1..)?.split('[').next()?;
    (!line.is_empty() && line.chars().all(|c| c.is_ascii_digit())).then_some(letter)
}
