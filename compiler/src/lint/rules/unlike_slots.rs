use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Axis, Device, Module, Object, Pdo, Repetition, Section, differences};
use crate::source::Location;

rule! {
    /// A module stands once in an ESI, for all slots that it is in. So what its axes have must be the same: an axis that
    /// lacks an object, or has another type or default, is another module.
    ///
    /// ## Fires
    /// ```toml
    /// [axes]
    /// names  = ["A", "B"]
    /// shifts = [{ range = "0x2000..=0x27FF", by = 0x800 }]
    ///
    /// [modules.0x100]
    /// name = "Servo axis"
    ///
    /// [objects.0x2000]
    /// name = "Ramp"
    /// type = "UINT16"
    /// per-axis.B = { type = "UINT32", note = "The second axis is slower." }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [axes]
    /// names  = ["A", "B"]
    /// shifts = [{ range = "0x2000..=0x27FF", by = 0x800 }]
    ///
    /// [modules]
    /// 0x100 = { name = "Servo axis", axes = ["A"] }
    /// 0x101 = { name = "Slow servo axis", axes = ["B"] }
    ///
    /// [objects.0x2000]
    /// name = "Ramp"
    /// type = "UINT16"
    /// per-axis.B = { type = "UINT32", note = "The second axis is slower." }
    /// ```
    pub(crate) static RULE = "unlike-slots", Output, Error,
        "axes share a module, but are not alike";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for module in &device.modules {
        let mut axes = device.axes_of(module);
        let Some(first) = axes.next() else { continue };
        for other in axes {
            if let Some((what, at)) = unlike(device, first, other) {
                report.push(Section::Modules.at(module.ident), told(module, [first, other], &what, at));
            }
        }
    }
}

fn told(module: &Module, axes: [&Axis; 2], what: &str, at: Location) -> Diagnostic {
    let [first, other] = axes.map(|axis| &axis.name);
    let message = format!("axes `{first}` and `{other}` share the module `{}`, but {what}", module.name);
    Diagnostic::new(&RULE, message, at, "not the same on both")
        .label(module.origin.header(), "the module of both")
        .help(format!("give `{other}` a module of its own"))
}

/// The first thing in which two axes are not alike, as the ESI tells it.
fn unlike(device: &Device, first: &Axis, other: &Axis) -> Option<(String, Location)> {
    let index = |axis: &Axis, all: &Repetition| all.axes.get(usize::from(axis.number)).copied().flatten();
    let object = |axis, all: &_| {
        let object = index(axis, all).and_then(|index| device.object(index));
        object.filter(|object| device.slot_of(object).is_some())
    };
    let pdo = |axis, all: &_| index(axis, all).and_then(|index| device.pdo(index));
    let missing = |index, axis: &Axis| format!("`{}` has no {index}", axis.name);
    device.repetitions.iter().find_map(|repetition| {
        let leading = repetition.leading;
        match (object(first, repetition), object(other, repetition)) {
            (Some(one), Some(same)) => return objects(one, same),
            (Some(one), None) => return Some((missing(leading, other), one.origin.header())),
            (None, Some(same)) => return Some((missing(leading, first), same.origin.header())),
            (None, None) => {}
        }
        match (pdo(first, repetition), pdo(other, repetition)) {
            (Some(one), Some(same)) => pdos(device, one, same),
            (Some(one), None) => Some((missing(leading, other), one.origin.header())),
            (None, Some(same)) => Some((missing(leading, first), same.origin.header())),
            (None, None) => None,
        }
    })
}

/// Fields that the ESI does not have, or that tell the axis.
const BESIDE: &[&str] = &[
    "index",
    "address",
    "axis",
    "id",
    "about",
    "note",
    "source",
    "parameter",
    "unit",
    "functional",
    "trigger",
    "entries",
    "excludes",
];

fn objects(one: &Object, other: &Object) -> Option<(String, Location)> {
    if one.entries.len() != other.entries.len() {
        return Some((
            format!("{} and {} have not the same entries", one.index, other.index),
            other.origin.header(),
        ));
    }
    let entries = one.entries.iter().zip(&other.entries);
    let of_entries = entries.flat_map(|(one, other)| {
        let found = differences(one, other).into_iter();
        found.map(move |difference| (one.address.to_string(), other.address.to_string(), difference))
    });
    let whole = differences(one, other).into_iter();
    let whole = whole.map(|difference| (one.index.to_string(), other.index.to_string(), difference));
    let mut found = whole.chain(of_entries).filter(|(_, _, difference)| {
        difference.path.0.first().is_some_and(|field| !BESIDE.contains(&field.as_str()))
    });
    found.next().map(|(one, same, difference)| {
        let field = difference.path.to_string().replace('_', " ");
        let at = difference.second_at.unwrap_or(other.origin.header());
        (format!("the {field} of {one} is not that of {same}"), at)
    })
}

fn pdos(device: &Device, one: &Pdo, other: &Pdo) -> Option<(String, Location)> {
    let carried = |pdo: &Pdo| -> Vec<_> {
        let leading = |index| {
            let axis = pdo.axis.unwrap_or_default();
            device.index_in_slot(axis, index).unwrap_or(index)
        };
        let entries = pdo.entries.iter();
        entries
            .map(|mapped| {
                let address = mapped.address.map(|address| (leading(address.index), address.subindex));
                (address, mapped.bits, mapped.data_type, mapped.name.clone())
            })
            .collect()
    };
    let is_assigned = |pdo: &Pdo| device.manager_of(pdo).map(|manager| manager.number);
    let same = carried(one) == carried(other)
        && (one.fixed, one.mandatory, is_assigned(one)) == (other.fixed, other.mandatory, is_assigned(other));
    let what = || format!("{} and {} differ in more than their indices", one.index, other.index);
    (!same).then(|| (what(), other.origin.header()))
}
