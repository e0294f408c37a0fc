//! Axes put together again: what each axis has, with the distance from one to the next.

use std::collections::BTreeSet;
use std::fmt::Debug;

use proc_macro2::TokenStream;
use quote::quote;

use super::literal::{distance, hex16};
use crate::model::{Device, Entry, Index, Mapped, Object, Pdo, Repeated};

/// Objects or PDOs that are one thing: of the device, or one of each axis.
#[derive(Debug)]
pub(super) struct Placed<'a, T> {
    /// The first, which stands for all.
    pub(super) first: &'a T,
    /// All, by axis; the first alone if it belongs to the device.
    pub(super) all: Vec<&'a T>,
    /// The distance in indices from an axis to the next; none if it belongs to the device.
    pub(super) shift: Option<u16>,
    /// The word for it.
    pub(super) id: String,
}

/// Something that each axis can have.
pub(super) trait OfAxis: Repeated + Debug {
    fn id(&self) -> String;
    /// Whether the other is the same on an axis that far away.
    fn is_like(&self, other: &Self, device: &Device, distance: u16) -> bool;
}

impl OfAxis for Object {
    fn id(&self) -> String {
        self.id.clone()
    }

    fn is_like(&self, other: &Self, _: &Device, _: u16) -> bool {
        self.kind == other.kind
            && self.entries.len() == other.entries.len()
            && self.entries.iter().zip(&other.entries).all(|(a, b)| is_entry_like(a, b))
    }
}

fn is_entry_like(a: &Entry, b: &Entry) -> bool {
    a.address.subindex == b.address.subindex
        && (&a.id, a.data_type, a.access, a.pdo) == (&b.id, b.data_type, b.access, b.pdo)
        && (&a.written, &a.values) == (&b.written, &b.values)
}

impl OfAxis for Pdo {
    fn id(&self) -> String {
        let direction = if self.direction == crate::model::Direction::Rx { "rx" } else { "tx" };
        format!("{direction}-pdo-{:04X}", self.index.0)
    }

    fn is_like(&self, other: &Self, device: &Device, distance: u16) -> bool {
        self.direction == other.direction
            && self.entries.len() == other.entries.len()
            && self.entries.iter().zip(&other.entries).all(|(a, b)| is_mapped_like(a, b, device, distance))
    }
}

fn is_mapped_like(a: &Mapped, b: &Mapped, device: &Device, distance: u16) -> bool {
    let moved = a.address.map(|address| {
        let by = shift(device, address.index).unwrap_or(0);
        (shifted(address.index, by, distance), address.subindex)
    });
    (&a.id, a.bits, a.data_type) == (&b.id, b.bits, b.data_type)
        && moved == b.address.map(|address| (Some(address.index), address.subindex))
}

/// The distance between the axes at an index of the first axis.
pub(super) fn shift(device: &Device, index: Index) -> Option<u16> {
    let of_range = device.arrangement.shifts.iter().find(|shift| (shift.first..=shift.last).contains(&index));
    match of_range {
        Some(shift) => Some(shift.by),
        None => device.pdo(index).filter(|pdo| pdo.axis.is_some()).map(|_| device.arrangement.pdo_shift),
    }
}

/// The index so many axes further.
pub(super) fn shifted(index: Index, by: u16, axes: u16) -> Option<Index> {
    by.checked_mul(axes).and_then(|distance| index.0.checked_add(distance)).map(Index)
}

/// Puts axes together where they are alike; what differs from axis to axis stays apart.
pub(super) fn placed<'a, T: OfAxis>(items: &'a [T], device: &Device) -> Vec<Placed<'a, T>> {
    let (mut placed, mut known): (Vec<Placed<'a, T>>, BTreeSet<Index>) = Default::default();
    for item in items {
        if known.contains(&item.index()) {
            continue;
        }
        let item = match across(item, items, device) {
            Some((all, shift)) => Placed { first: item, all, shift: Some(shift), id: item.id() },
            None => Placed { first: item, all: vec![item], shift: None, id: alone(item, device) },
        };
        known.extend(item.all.iter().map(|item| item.index()));
        placed.push(item);
    }
    placed
}

/// The item on every axis, with the distance.
fn across<'a, T: OfAxis>(item: &'a T, items: &'a [T], device: &Device) -> Option<(Vec<&'a T>, u16)> {
    let repetition =
        device.repetition(item.leading()).filter(|_| device.axes.len() > 1 && item.is_leading())?;
    let of_axis = |(index, number): (&Option<Index>, u16)| {
        let index = (*index)?;
        let place = items.binary_search_by_key(&index, Repeated::index).ok();
        let other =
            place.and_then(|place| items.get(place)).or_else(|| items.iter().find(|i| i.index() == index))?;
        item.is_like(other, device, number).then_some(other)
    };
    let all = repetition.axes.iter().zip(0..).map(of_axis).collect::<Option<Vec<_>>>()?;
    Some((all, shift(device, item.index())?))
}

/// The word for an item of one axis.
fn alone<T: OfAxis>(item: &T, device: &Device) -> String {
    let axis = item.axis().filter(|_| device.axes.len() > 1);
    match axis.and_then(|axis| device.axes.get(usize::from(axis))) {
        Some(axis) if !item.id().ends_with(&format!("{:x}", item.index().0)) => {
            format!("{}-{}", item.id(), axis.name)
        }
        _ => item.id(),
    }
}

/// The index on `axis`, a variable of generated code, or the index alone.
pub(super) fn index(first: Index, shift: Option<u16>) -> TokenStream {
    let first = hex16(first.0);
    match shift.map(distance) {
        Some(shift) => quote!(axis.index(#first, #shift)),
        None => quote!(#first),
    }
}
