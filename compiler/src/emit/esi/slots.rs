//! `Slots` and `Modules`: the second form of an ESI for several axes, in which what each axis has stands once.

use std::collections::BTreeMap;

use super::element::Element;
use super::frame::Frame;
use super::literal::Hex;
use super::{pdo, profile};
use crate::model::{Axis, Device, Direction, Family, Module, ModuleClass, Slot};

/// A slot for each axis, which always holds its module; none if the device has no modules.
pub(super) fn slots(device: &Device) -> Option<Element> {
    let of_axes: Vec<Element> = device.axes.iter().filter_map(|axis| slot(device, axis)).collect();
    let shift = device.arrangement.shifts.first().filter(|_| !of_axes.is_empty());
    let first = device.slots.first().map(|slot| (slot.pdo_step, slot.index_step));
    let steps = shift.map(|shift| (device.arrangement.pdo_shift, shift.by)).or(first)?;
    let open = device.slots.iter().map(|slot| open(slot, steps));
    Element::new("Slots")
        .with("SlotPdoIncrement", steps.0)
        .with("SlotIndexIncrement", Hex(steps.1))
        .children(of_axes)
        .children(open)
        .unless_empty()
}

/// A slot that modules can be put into; what it has otherwise than the others, it says itself.
fn open(slot: &Slot, (pdos, objects): (u16, u16)) -> Element {
    let class = |class: &ModuleClass| {
        let name = class.name.iter().flat_map(|name| Element::in_languages("Name", name, &class.names));
        Element::new("ModuleClass").child(Element::leaf("Class", &class.class)).children(name)
    };
    let module = |ident: &u32| {
        let is_default = slot.default == Some(*ident);
        Element::leaf("ModuleIdent", Hex(*ident)).with_some("Default", is_default.then_some("1"))
    };
    Element::new("Slot")
        .with("MinInstances", slot.min)
        .with("MaxInstances", slot.max)
        .with_some("SlotPdoIncrement", (slot.pdo_step != pdos).then_some(slot.pdo_step))
        .with_some("SlotIndexIncrement", (slot.index_step != objects).then_some(Hex(slot.index_step)))
        .children(Element::in_languages("Name", &slot.name, &slot.names))
        .children(slot.modules.iter().map(module))
        .children(slot.classes.iter().map(class))
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
