//! `RxPdo` and `TxPdo`: what can be exchanged in every cycle.

use super::element::Element;
use super::frame::Frame;
use super::{names, primitive};
use crate::model::{Device, Direction, Index, Mapped, Oversampling, Pdo, Role};

/// The PDOs of a direction.
pub(super) fn in_order(frame: Frame<'_>, direction: Direction) -> Vec<Element> {
    let pdos = frame.device().pdos_in_order(direction).into_iter();
    pdos.filter(|it| frame.carries(it)).map(|it| pdo(frame, it)).collect()
}

/// A PDO. Only one that is assigned at start-up names its sync manager.
fn pdo(frame: Frame<'_>, pdo: &Pdo) -> Element {
    let device = frame.device();
    let tag = match pdo.direction {
        Direction::Rx => "RxPdo",
        Direction::Tx => "TxPdo",
    };
    let oversampling = |of: fn(Oversampling) -> Option<u16>| pdo.oversampling.and_then(of);
    Element::new(tag)
        .with_some("Fixed", pdo.fixed.then_some("1"))
        .with_some("Mandatory", pdo.mandatory.then_some("1"))
        .with_some("Sm", device.manager_of(pdo).map(|manager| manager.number))
        .with_some("Su", sync_unit(device, pdo))
        .with_some("Virtual", pdo.r#virtual.then_some("1"))
        .with_some("OSFac", oversampling(|it| Some(it.factor)))
        .with_some("OSMin", oversampling(|it| it.min))
        .with_some("OSMax", oversampling(|it| it.max))
        .with_some("OSIndexInc", oversampling(|it| it.step))
        .child(frame.pdo("Index", pdo.index))
        .children(names::named(frame, &pdo.name, &pdo.names, pdo.axis))
        .children(excludes(device, pdo).into_iter().map(|other| frame.pdo("Exclude", other)))
        .children(pdo.entries.iter().map(|mapped| entry(frame, pdo, mapped)))
}

/// The place of its sync unit among the `Su` elements.
fn sync_unit(device: &Device, pdo: &Pdo) -> Option<usize> {
    let unit = pdo.sync_unit.as_deref()?;
    device.sync_units().iter().position(|known| *known == unit)
}

/// The PDOs that cannot be assigned together with another: those it names, and all others of its direction if the sync
/// manager is said to take one at a time.
fn excludes(device: &Device, pdo: &Pdo) -> Vec<Index> {
    let role = match pdo.direction {
        Direction::Rx => Role::Outputs,
        Direction::Tx => Role::Inputs,
    };
    let mut managers = device.sync_managers_of(role);
    let single = managers.next().is_some_and(|manager| manager.slots == 1 && manager.origin.has("slots"));
    if !single || managers.next().is_some() {
        return pdo.excludes.clone();
    }
    device.pdos_of(pdo.direction).map(|other| other.index).filter(|other| *other != pdo.index).collect()
}

fn entry(frame: Frame<'_>, pdo: &Pdo, mapped: &Mapped) -> Element {
    let Some(address) = mapped.address else { return padding(mapped) };
    // The type of another width than the one mapped would move all that follows in tools that go by types.
    let data_type = mapped.told_type().filter(|data_type| data_type.bits() == mapped.bits);
    let data_type = data_type.map_or_else(|| primitive::of_width(mapped.bits), primitive::name);
    Element::new("Entry")
        .child(frame.object(address.index))
        .child(Element::leaf("SubIndex", address.subindex))
        .child(Element::leaf("BitLen", mapped.bits))
        .children(names::mapped(frame, pdo, mapped))
        .child(mapped.about.as_ref().map(|about| Element::leaf("Comment", about)))
        .child(Element::leaf("DataType", data_type))
}

/// What is left free. A name is there only if the description gives it one: by names such as `Status__`, tools that make
/// structures of a PDO put it into one of these.
fn padding(mapped: &Mapped) -> Element {
    let names =
        (mapped.name != Mapped::PADDING).then(|| Element::in_languages("Name", &mapped.name, &mapped.names));
    Element::new("Entry")
        .child(Element::leaf("Index", "#x0"))
        .child(Element::leaf("BitLen", mapped.bits))
        .children(names.into_iter().flatten())
}
