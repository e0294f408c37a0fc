//! What is written once for all axes: the first axis stands for the others.

use std::collections::BTreeMap;

use super::Context;
use crate::model::{Device, Index, Object, Pdo};

/// The objects that axes have, by the id that those of all axes share, in the order of the dictionary.
#[derive(Debug)]
pub(super) struct OfAxes<'a>(BTreeMap<&'a str, Vec<&'a Object>>);

impl<'a> OfAxes<'a> {
    pub(super) fn new(device: &'a Device) -> Self {
        let mut of_axes: BTreeMap<&str, Vec<&Object>> = BTreeMap::new();
        for object in device.objects.iter().filter(|object| object.axis.is_some()) {
            of_axes.entry(&object.id).or_default().push(object);
        }
        Self(of_axes)
    }

    /// The objects of axes that are the same as this one, itself included if it is one of an axis.
    fn repeating(&self, object: &Object) -> &[&'a Object] {
        self.0.get(object.id.as_str()).map_or(&[], Vec::as_slice)
    }
}

impl<'a> Context<'a> {
    /// Whether there is more than one axis.
    pub(in crate::emit::markdown) fn has_axes(&self) -> bool {
        self.device.axes.len() > 1
    }

    /// The names of the axes.
    pub(in crate::emit::markdown) fn axis_names(&self) -> impl Iterator<Item = &'a str> {
        self.device.axes.iter().map(|axis| axis.name.as_str())
    }

    /// Axes in running text: `all axes`, `axis X`, `axes Y to W`.
    pub(in crate::emit::markdown) fn axes(&self, numbers: &[u8]) -> String {
        match numbers {
            _ if numbers.len() == self.device.axes.len() => "all axes".into(),
            [_] => format!("axis {}", self.axis_range(numbers)),
            _ => format!("axes {}", self.axis_range(numbers)),
        }
    }

    /// Axes by name: `X`, `Y to W`, `X, Z`.
    pub(in crate::emit::markdown) fn axis_range(&self, numbers: &[u8]) -> String {
        let name =
            |number: &u8| self.device.axes.get(usize::from(*number)).map_or("?", |axis| axis.name.as_str());
        let row = numbers
            .iter()
            .zip(numbers.iter().skip(1))
            .all(|(one, next)| u16::from(*one) + 1 == u16::from(*next));
        match numbers {
            [first, .., last] if row && numbers.len() > 2 => format!("{} to {}", name(first), name(last)),
            _ => numbers.iter().map(name).collect::<Vec<_>>().join(", "),
        }
    }

    /// The index of the object of the first axis that this one repeats; its own if it repeats none.
    pub(in crate::emit::markdown) fn leading_object(&self, object: &Object) -> Index {
        let leading = object.axis.and_then(|_| self.of_axes.repeating(object).first());
        leading.map_or(object.index, |leading| leading.index)
    }

    /// The objects to print: those of the whole device, and one for all axes.
    pub(in crate::emit::markdown) fn leading_objects(&self) -> impl Iterator<Item = &'a Object> {
        self.device.objects.iter().filter(|object| self.leading_object(object) == object.index)
    }

    /// The object as it is on each axis.
    pub(in crate::emit::markdown) fn on_axes(&self, object: &Object) -> Vec<Option<&'a Object>> {
        let all = self.of_axes.repeating(object);
        let on = |number| all.iter().find(|other| other.axis == Some(number)).copied();
        self.device.axes.iter().map(|axis| on(axis.number)).collect()
    }

    /// The index of the PDO of the first axis that this one repeats; its own if it repeats none.
    pub(in crate::emit::markdown) fn leading_pdo(&self, pdo: &Pdo) -> Index {
        let first =
            pdo.axis.and_then(|axis| pdo.index.0.checked_sub(u16::from(axis) * self.device.pdo_shift));
        let leading = first.and_then(|index| self.device.pdo(Index(index)));
        leading.filter(|leading| leading.axis == Some(0) && repeats(pdo, leading)).unwrap_or(pdo).index
    }

    /// The PDOs to print: those of the whole device, and one for all axes.
    pub(in crate::emit::markdown) fn leading_pdos(&self) -> impl Iterator<Item = &'a Pdo> {
        self.device.pdos.iter().filter(|pdo| self.leading_pdo(pdo) == pdo.index)
    }

    /// The PDO as it is on each axis.
    pub(in crate::emit::markdown) fn pdo_on_axes(&self, leading: &Pdo) -> Vec<Option<&'a Pdo>> {
        let repeats = |pdo: &&Pdo| self.leading_pdo(pdo) == leading.index;
        let same: Vec<&Pdo> = self.device.pdos.iter().filter(repeats).collect();
        let on = |number| same.iter().find(|pdo| pdo.axis == Some(number)).copied();
        self.device.axes.iter().map(|axis| on(axis.number)).collect()
    }
}

fn repeats(pdo: &Pdo, leading: &Pdo) -> bool {
    let layout = |pdo: &Pdo| -> Vec<(u32, u32, Option<u8>)> {
        pdo.entries
            .iter()
            .map(|entry| (entry.offset, entry.bits, entry.address.map(|at| at.subindex)))
            .collect()
    };
    layout(pdo) == layout(leading)
}
