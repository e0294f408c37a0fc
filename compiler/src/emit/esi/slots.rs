//! `Slots` and `Modules`: the second form of an ESI for several axes, in which what each axis has stands once.

use std::collections::BTreeMap;

use super::element::Element;
use super::frame::Frame;
use super::literal::Hex;
use super::{pdo, profile};
use crate::model::{Axis, Device, Direction, Family, Module};

/// A slot for each axis, which always holds its module; none if the device has no modules.
pub(super) fn slots(device: &Device) -> Option<Element> {
    let step = device.arrangement.shifts.first()?.by;
    let slots = device.axes.iter().flat_map(|axis| slot(device, axis));
    Element::new("Slots")
        .with("SlotPdoIncrement", device.arrangement.pdo_shift)
        .with("SlotIndexIncrement", Hex(step))
        .children(slots)
        .unless_empty()
}

fn slot(device: &Device, axis: &Axis) -> Option<Element> {
    let module = device.modules.iter().find(|module| module.has(axis))?;
    let ident = Element::leaf("ModuleIdent", Hex(module.ident)).with("Default", 1);
    let slot = Element::new("Slot").with("MinInstances", 1).with("MaxInstances", 1);
    Some(slot.child(Element::worded("Name", &axis.name)).child(ident))
}

/// The modules of all members, each once.
pub(super) fn modules(family: &Family) -> Option<Element> {
    let mut modules = BTreeMap::new();
    for device in &family.members {
        for described in &device.modules {
            modules.entry(described.ident).or_insert_with(|| module(device, described));
        }
    }
    Element::new("Modules").children(modules.into_values().flatten()).unless_empty()
}

/// A module, as it is in the first of its slots.
fn module(device: &Device, module: &Module) -> Option<Element> {
    let frame = Frame::Slot(device, device.axes_of(module).next()?.number);
    let described = Element::new("Module")
        .child(Element::leaf("Type", &module.name).with("ModuleIdent", Hex(module.ident)))
        .child(Element::worded("Name", &module.name))
        .children(pdo::in_order(frame, Direction::Rx))
        .children(pdo::in_order(frame, Direction::Tx))
        .child(profile::of_module(frame));
    Some(described)
}
