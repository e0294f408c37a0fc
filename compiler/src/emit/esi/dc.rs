//! `Dc`: the ways to keep time with the master.

use super::element::Element;
use super::literal::{Hex, prose};
use crate::model::{Device, ModeManager, SyncMode, SyncSignal};

/// The operation modes, the default first; none if the device makes no use of distributed clocks.
pub(super) fn dc(device: &Device) -> Option<Element> {
    let modes = device.clock_modes().iter().map(|mode| op_mode(device, mode));
    Element::new("Dc").children(modes).unless_empty()
}

fn op_mode(device: &Device, mode: &SyncMode) -> Element {
    Element::new("OpMode")
        .child(Element::leaf("Name", &mode.id))
        .child(Element::leaf("Desc", prose(&mode.name)))
        .child(Element::leaf("AssignActivate", format_args!("#x{:03X}", mode.assign_activate)))
        .children(mode.sync0.iter().flat_map(|signal| times(signal, "CycleTimeSync0", "ShiftTimeSync0")))
        .children(mode.sync1.iter().flat_map(|signal| times(signal, "CycleTimeSync1", "ShiftTimeSync1")))
        .children(mode.managers.iter().filter_map(|manager| sync_manager(device, manager)))
}

/// What a sync manager does other than by default.
fn sync_manager(device: &Device, manager: &ModeManager) -> Option<Element> {
    let number = device.sync_managers.iter().find(|known| known.id == manager.id)?.number;
    let pdos = manager.pdos.iter();
    let pdos = pdos.map(|it| Element::leaf("Pdo", Hex(it.pdo.0)).with_some("OSFac", it.oversampling));
    let sync_type = manager.sync_type.map(|kind| Element::leaf("SyncType", kind));
    Some(Element::new("Sm").with("No", number).child(sync_type).children(pdos))
}

/// A period of 0 ns leaves it to the factor: so many cycles of the master. One that is a time of its own has no factor.
fn times(signal: &SyncSignal, cycle: &'static str, shift: &'static str) -> [Element; 2] {
    let period = match signal.period {
        Some(period) => Element::leaf(cycle, period.0),
        None => Element::leaf(cycle, 0).with("Factor", signal.cycles),
    };
    let shift = Element::leaf(shift, signal.shift.0)
        .with_some("Factor", signal.shift_cycles)
        .with_some("Input", signal.of_inputs.then_some("1"));
    [period, shift]
}
