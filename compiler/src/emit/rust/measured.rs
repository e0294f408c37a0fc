//! Units with what they measure on each axis.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::axes::Placed;
use super::measure::Means;
use super::names::{Names, camel, shout, snake};
use crate::model::{AxisUnit, Device, Object, Scale, Unit};

/// A unit as generated code has it.
#[derive(Debug)]
pub(super) struct Measured<'a> {
    pub(super) unit: &'a Unit,
    /// A constant for all axes on which the unit measures the same, in the same steps.
    pub(super) constants: Vec<Constant<'a>>,
    /// The function of the axis, if axes differ and one type holds what they have.
    pub(super) of_axis: Option<(Ident, Means)>,
}

#[derive(Debug)]
pub(super) struct Constant<'a> {
    pub(super) name: Ident,
    pub(super) axes: Vec<usize>,
    /// What the unit is on the first of them.
    pub(super) first: &'a AxisUnit,
    pub(super) means: Means,
    /// Raw steps to so many of the quantity's smallest unit.
    pub(super) scale: Scale,
}

/// All units of a device but those whose numbers are beyond the runtime's.
pub(super) fn all(device: &Device, has_axes: bool) -> Vec<Measured<'_>> {
    let mut names = Names::default();
    device.units.iter().filter_map(|unit| Measured::of(unit, device, has_axes, &mut names)).collect()
}

/// The runtime's types that the units need, each once, by name.
pub(super) fn types(units: &[Measured<'_>]) -> BTreeSet<Ident> {
    units.iter().flat_map(Measured::means).flat_map(Means::imports).map(camel).collect()
}

impl<'a> Measured<'a> {
    fn of(unit: &'a Unit, device: &Device, has_axes: bool, names: &mut Names) -> Option<Self> {
        let mut constants: Vec<Constant<'a>> = Vec::new();
        for (axis, first) in unit.axes.iter().enumerate() {
            let (means, scale) = Means::of(first)?;
            let is_same =
                |known: &&mut Constant<'_>| known.scale == scale && known.first.symbol == first.symbol;
            match constants.iter_mut().find(is_same) {
                Some(constant) => constant.axes.push(axis),
                // which name it gets depends on those that are still to come
                None => {
                    constants.push(Constant { name: shout(&unit.id), axes: vec![axis], first, means, scale })
                }
            }
        }
        let means: Vec<Means> = constants.iter().map(|constant| constant.means).collect();
        let of_axis = Means::of_axes(&means).filter(|_| has_axes && constants.len() > 1);
        let wanted = wanted(unit, device, &constants);
        for (constant, wanted) in constants.iter_mut().zip(wanted) {
            constant.name = names.claim(&wanted);
        }
        let of_axis = of_axis.map(|means| (names.claim(&snake(&unit.id)), means));
        Some(Self { unit, constants, of_axis })
    }

    /// The names of its items.
    pub(super) fn names(&self) -> impl Iterator<Item = &Ident> {
        let of_axis = self.of_axis.iter().map(|(name, _)| name);
        self.constants.iter().map(|constant| &constant.name).chain(of_axis)
    }

    /// The types of its items.
    fn means(&self) -> impl Iterator<Item = Means> {
        let of_axis = self.of_axis.iter().map(|(_, means)| *means);
        self.constants.iter().map(|constant| constant.means).chain(of_axis)
    }

    /// What values measure, and the place of their unit: values of one axis, of all axes, or of the device.
    pub(super) fn at(&self, placed: &Placed<'_, Object>) -> Option<(Means, TokenStream)> {
        let constant = match (self.constants.as_slice(), placed.first.axis) {
            ([only], _) => only,
            (_, Some(axis)) if placed.shift.is_none() => {
                self.constants.iter().find(|constant| constant.axes.contains(&usize::from(axis)))?
            }
            _ if placed.shift.is_some() => {
                let (function, means) = self.of_axis.as_ref()?;
                return Some((*means, quote!(units::#function(axis))));
            }
            _ => return None,
        };
        let name = &constant.name;
        (!constant.is_bare()).then(|| (constant.means, quote!(units::#name)))
    }
}

impl Constant<'_> {
    /// Whether the numbers are already what they count.
    fn is_bare(&self) -> bool {
        self.means == Means::Own && self.scale == Scale { raw: 1, units: 1 }
    }
}

/// A name for each: that of the unit if it is the only one, else with the symbol, or with the axis if others have the
/// symbol, too.
fn wanted(unit: &Unit, device: &Device, constants: &[Constant<'_>]) -> Vec<Ident> {
    let id = |constant: &Constant<'_>| {
        let symbol = &constant.first.symbol;
        let is_unique = constants.iter().filter(|other| other.first.symbol == *symbol).count() == 1;
        let axis = constant.axes.first().and_then(|axis| device.axes.get(*axis));
        match axis {
            _ if constants.len() == 1 => unit.id.clone(),
            Some(axis) if !is_unique => format!("{}-{}", unit.id, axis.name),
            _ => format!("{}-{}", unit.id, word(symbol)),
        }
    };
    constants.iter().map(|constant| shout(&id(constant))).collect()
}

/// A word for a symbol, where a unit has several: `mm/s` is `mm-per-s`.
fn word(symbol: &str) -> String {
    symbol.replace('µ', "u").replace('°', "deg").replace('²', "2").replace('/', "-per-")
}
