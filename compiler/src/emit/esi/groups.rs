//! `Groups`: the folders under which a tool lists the devices.

use super::element::Element;
use crate::model::Family;

/// Each group of the family once, in the order of the devices.
pub(super) fn groups(family: &Family) -> Element {
    let mut names: Vec<&str> = Vec::new();
    for device in &family.members {
        if !names.contains(&device.group.as_str()) {
            names.push(&device.group);
        }
    }
    Element::new("Groups").children(names.into_iter().map(group))
}

fn group(name: &str) -> Element {
    Element::new("Group").child(Element::leaf("Type", name)).child(Element::worded("Name", name))
}
