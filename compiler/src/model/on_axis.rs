//! Names that tell the axis: tools list PDOs and objects by name, and generators make code of them.

use super::Device;

impl Device {
    /// A name with the axis behind it, unless it tells the axis already or there is but one.
    pub fn on_axis(&self, name: &str, axis: Option<u8>) -> String {
        let axis = axis.filter(|_| self.axes.len() > 1);
        let axis = axis.and_then(|number| self.axes.get(usize::from(number))).map(|axis| axis.name.as_str());
        match axis.filter(|axis| !axis.is_empty() && !tells(name, axis)) {
            Some(axis) => format!("{name} ({axis})"),
            None => name.to_owned(),
        }
    }
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
