use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Object};

rule! {
    /// The axes of a device are of one kind, and a master drives them with one program. An object that has another
    /// shape or type on one of them breaks that program; often a table was printed for one axis and
    /// copied badly for the next.
    ///
    /// What differs for a reason has a `note` for the axis that tells it.
    ///
    /// ## Fires
    /// ```toml
    /// [axes]
    /// names = ["A", "B"]
    /// shifts = [{ range = "0x2000..=0x20FF", by = 0x800 }]
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "INT32"
    /// per-axis.B = { type = "INT16" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [axes]
    /// names = ["A", "B"]
    /// shifts = [{ range = "0x2000..=0x20FF", by = 0x800 }]
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "INT32"
    /// per-axis.B = { type = "INT16", note = "The second encoder has fewer bits." }
    /// ```
    pub(super) static RULE = "differing-axis", Dictionary, Warning,
        "an object differs on one axis, and nothing says why";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for object in lookup::objects(device).filter(|object| object.axis.is_some_and(|axis| axis > 0)) {
        let Some(first) = device.object(object.leading) else { continue };
        let Some((key, what)) = difference(first, object).filter(|_| object.note == first.note) else {
            continue;
        };
        let message = format!("{} {what} than {} on the first axis", object.index, first.index);
        let diagnostic = Diagnostic::new(&RULE, message, object.origin.value(key), "different here")
            .label(first.origin.value(key), "on the first axis")
            .help("add a `note` for the axis that says why");
        report.push(object.index, diagnostic);
    }
}

/// The first thing in which an object differs from that of the first axis, if nothing says why.
fn difference(first: &Object, object: &Object) -> Option<(&'static str, &'static str)> {
    if first.kind != object.kind {
        return Some(("kind", "is of another kind"));
    }
    if first.entries.len() != object.entries.len() {
        return Some(("entries", "has other entries"));
    }
    let pairs = || first.entries.iter().zip(&object.entries).filter(|(a, b)| a.note == b.note);
    let types = pairs().any(|(a, b)| a.data_type != b.data_type).then_some(("type", "has another type"));
    types.or_else(|| pairs().any(|(a, b)| a.access != b.access).then_some(("access", "has other access")))
}
