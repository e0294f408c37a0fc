use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// Without its number, nobody can tell the indices of the parameters in a group.
    ///
    /// ## Fires
    /// ```toml
    /// [coordinates]
    /// base = 0x2000
    /// group-size = 512
    ///
    /// [coordinates.groups]
    /// A = { number = 0, name = "Drive" }
    /// L = { name = "Technology" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [coordinates]
    /// base = 0x2000
    /// group-size = 512
    ///
    /// [coordinates.groups]
    /// A = { number = 0, name = "Drive" }
    /// L = { number = 11, name = "Technology" }
    /// ```
    pub(super) static RULE = "unnumbered-group", Values, Warning, "a group of parameters has no number";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let Some(coordinates) = &device.coordinates else { return };
    for group in coordinates.groups.iter().filter(|group| group.number.is_none()) {
        let path = format!("groups.{}", group.letter);
        let message = format!("group {}, `{}`, has no number", group.letter, group.name);
        let diagnostic = Diagnostic::new(&RULE, message, coordinates.origin.value(&path), "no `number`")
            .note("the index of a parameter follows from the number of its group");
        report.push(Section::Coordinates.at(path), diagnostic);
    }
}
