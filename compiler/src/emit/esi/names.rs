//! Names that tell the axis: tools list PDOs and objects by name, and generators make code of them.

use crate::model::{Device, Mapped, Pdo};

/// A name with the axis behind it, unless it tells the axis already or there is but one.
pub(super) fn on_axis(device: &Device, name: &str, axis: Option<u8>) -> String {
    let axis = axis.filter(|_| device.axes.len() > 1);
    let axis = axis.and_then(|number| device.axes.get(usize::from(number))).map(|axis| axis.name.as_str());
    match axis.filter(|axis| !axis.is_empty() && !tells(name, axis)) {
        Some(axis) => format!("{name} ({axis})"),
        None => name.to_owned(),
    }
}

/// The name of what a PDO carries, with the axis of the object; what the dictionary lacks is of the PDO's axis.
pub(super) fn mapped(device: &Device, pdo: &Pdo, mapped: &Mapped) -> String {
    let object = mapped.address.and_then(|address| device.object(address.index));
    on_axis(device, &mapped.name, object.map_or(pdo.axis, |object| object.axis))
}

/// Whether a name has the axis in it, as a word of its own.
fn tells(name: &str, axis: &str) -> bool {
    let ends = |c: Option<char>| c.is_none_or(|c| !c.is_alphanumeric());
    name.match_indices(axis).any(|(start, found)| {
        let before = name.get(..start).and_then(|text| text.chars().next_back());
        let behind = name.get(start + found.len()..).and_then(|text| text.chars().next());
        ends(before) && ends(behind)
    })
}
