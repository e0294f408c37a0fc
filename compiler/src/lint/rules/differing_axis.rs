use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Entry, Object, Place};
use crate::source::Origin;

rule! {
    /// The axes of a device are of one kind, and a master drives them with one program. An object that has another
    /// shape, type or name on one of them breaks that program; often a table was printed for one axis and
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
        let Some(first) = device.object(object.leading).filter(|first| first.note == object.note) else {
            continue;
        };
        let Some(Difference { sides: [one, other], key, what }) = difference(first, object) else { continue };
        // The profile may know which of them is wrong.
        let is_first = departs(report, one.origin, key) && !departs(report, other.origin, key);
        let (stray, like) = if is_first { (one, other) } else { (other, one) };
        let message = format!("{} {what} than {}, the same on another axis", stray.name, like.name);
        let diagnostic = Diagnostic::new(&RULE, message, stray.origin.value(key), "different here")
            .label(like.origin.value(key), "on the other axis")
            .help("add a `note` for the axis that says why");
        report.push(stray.name, diagnostic);
    }
}

/// One thing in which an object differs from that of the first axis, which comes first.
struct Difference<'d> {
    sides: [Side<'d>; 2],
    key: &'static str,
    what: &'static str,
}

struct Side<'d> {
    name: Place,
    origin: &'d Origin,
}

/// Whether a profile says something else under this key.
fn departs(report: &Report, origin: &Origin, key: &str) -> bool {
    let profile = report.profile(origin, key);
    profile.is_some_and(|profile| origin.node(key).is_none_or(|own| own.value != profile.value))
}

/// The first thing in which an object differs from that of the first axis, if nothing says why.
fn difference<'d>(first: &'d Object, object: &'d Object) -> Option<Difference<'d>> {
    let whole = |object: &'d Object| Side { name: object.index.into(), origin: &object.origin };
    let objects = |key, what| Some(Difference { sides: [whole(first), whole(object)], key, what });
    // an array that can be none is another fault
    let is_possible = [first, object].into_iter().all(|object| lookup::of_two_types(object).is_none());
    if first.kind != object.kind && is_possible {
        return objects("kind", "is of another kind");
    }
    if first.name != object.name {
        return objects("name", "has another name");
    }
    if first.entries.len() != object.entries.len() {
        return objects("entries", "has other entries");
    }
    let pairs = first.entries.iter().zip(&object.entries).filter(|(one, other)| one.note == other.note);
    let mut found = pairs.filter_map(|(one, other)| {
        let (key, what) = value_difference(one, other)?;
        let side =
            |object, entry: &'d Entry| Side { name: lookup::name(object, entry), origin: &entry.origin };
        Some(Difference { sides: [side(first, one), side(object, other)], key, what })
    });
    found.next()
}

fn value_difference(one: &Entry, other: &Entry) -> Option<(&'static str, &'static str)> {
    if one.data_type != other.data_type {
        return Some(("type", "has another type"));
    }
    if one.access != other.access {
        return Some(("access", "has other access"));
    }
    (one.name != other.name).then_some(("name", "has another name"))
}
