use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Group, Section};

rule! {
    /// Each group of parameters has indices of its own. Two groups with one number share them, so that one
    /// index names two parameters.
    ///
    /// ## Fires
    /// ```toml
    /// [coordinates]
    /// base = 0x2000
    /// group-size = 512
    ///
    /// [coordinates.groups]
    /// A = { number = 1, name = "Drive" }
    /// B = { number = 1, name = "Motor" }
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
    /// B = { number = 1, name = "Motor" }
    /// ```
    pub(super) static RULE = "overlapping-groups", Values, Error, "two groups of parameters share indices";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let Some(coordinates) = &device.coordinates else { return };
    for (i, second) in coordinates.groups.iter().enumerate() {
        let Some(first) = coordinates.groups.iter().take(i).find(|first| share(first, second)) else {
            continue;
        };
        let message = format!("groups {} and {} share indices", first.letter, second.letter);
        let place = |group: &Group| coordinates.origin.value(&format!("groups.{}", group.letter));
        let diagnostic =
            Diagnostic::new(&RULE, message, place(second), extent(second)).label(place(first), extent(first));
        report.push(Section::Coordinates.at("groups").at(&second.letter), diagnostic);
    }
}

/// What makes the indices of a group.
fn extent(group: &Group) -> String {
    match (group.number, group.range) {
        (Some(number), _) => format!("{} has number {number}", group.letter),
        (None, Some((first, last))) => format!("{} has {first} to {last}", group.letter),
        (None, None) => String::new(),
    }
}

/// Whether two groups have one number, or ranges that meet where there are no numbers.
fn share(first: &Group, second: &Group) -> bool {
    match (first.number, second.number) {
        (Some(a), Some(b)) => a == b,
        (None, None) => {
            matches!((first.range, second.range), (Some(a), Some(b)) if a.0 <= b.1 && b.0 <= a.1)
        }
        _ => false,
    }
}
