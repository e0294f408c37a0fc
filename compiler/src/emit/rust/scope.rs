//! What all parts of a module know.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::Options;
use super::axes::{Placed, placed};
use super::item::{Item, Space};
use super::measured::{self, Measured};
use super::names::{Names, camel, snake};
use super::types::{Primitive, Types};
use crate::model::{Device, Object, Pdo};

/// Names that every module has or that it imports.
const RESERVED: &[&str] = &[
    "Access",
    "Address",
    "AlStatusCode",
    "Axis",
    "AxisObjects",
    "Bit2",
    "Bit3",
    "Bit4",
    "Bit5",
    "Bit6",
    "Bit7",
    "BitField",
    "BringUp",
    "Carrier",
    "Command",
    "Condition",
    "Constant",
    "Coupling",
    "CycleLimit",
    "DataType",
    "Device",
    "Edge",
    "Entry",
    "EntryInfo",
    "ErrorInfo",
    "ErrorRange",
    "Events",
    "Family",
    "HomingBits",
    "Inputs",
    "Int24",
    "Int40",
    "Int48",
    "Int56",
    "Machine",
    "MappedPdo",
    "Mapping",
    "MappingObject",
    "Members",
    "Mode",
    "ModeChange",
    "ModeOfOperation",
    "Modes",
    "ObjectCode",
    "ObjectInfo",
    "Option",
    "Outputs",
    "Page",
    "Pattern",
    "Pdo",
    "ProcessData",
    "ProcessImage",
    "ReadOnly",
    "ReadWrite",
    "Refusal",
    "Result",
    "Rx",
    "RxTx",
    "State",
    "StatePatterns",
    "StateSet",
    "SyncManager",
    "Transition",
    "Tx",
    "Uint24",
    "Uint40",
    "Uint48",
    "Uint56",
    "UnknownState",
    "Unmapped",
    "VendorCode",
    "Write",
    "WriteOnly",
];

/// A device with what its code is made of.
#[derive(Debug)]
pub(super) struct Scope<'a> {
    pub(super) device: &'a Device,
    /// The path of the runtime crate.
    pub(super) runtime: &'a TokenStream,
    /// The type that stands for the device.
    pub(super) marker: Ident,
    /// The type that its entries and its process data belong to: the device, or its family.
    pub(super) owner: Ident,
    /// Its place in its family.
    pub(super) member: u16,
    /// The units that members of the family do not have in common.
    pub(super) unlike: BTreeSet<&'a str>,
    /// The visibility of what the modules of a family share that is nobody else's: from two modules up, and from one.
    pub(super) within: (TokenStream, TokenStream),
    /// Whether the type is declared beside the module.
    pub(super) marker_is_outside: bool,
    /// Whether something of the device is there for each axis.
    pub(super) has_axes: bool,
    /// The objects, those of axes together.
    pub(super) objects: Vec<Placed<'a, Object>>,
    /// The PDOs, those of axes together.
    pub(super) pdos: Vec<Placed<'a, Pdo>>,
    pub(super) types: Types<'a>,
    pub(super) units: Vec<Measured<'a>>,
}

impl<'a> Scope<'a> {
    /// A device that is alone, or a member of a family at a place.
    pub(super) fn new(device: &'a Device, member: Option<u16>, options: &'a Options) -> Self {
        let objects = placed(&device.objects, device);
        let pdos = placed(&device.pdos, device);
        let has_axes =
            objects.iter().any(|object| object.shift.is_some()) || pdos.iter().any(|pdo| pdo.shift.is_some());
        let units = measured::all(device, has_axes);
        let mut names = Names::with(RESERVED);
        for name in measured::types(&units) {
            names.claim(&name);
        }
        let wanted = options.device.clone().unwrap_or_else(|| camel(&device.id));
        let marker = if options.device.is_some() { wanted } else { names.claim(&wanted) };
        let types = Types::of(device, &mut names);
        let (runtime, marker_is_outside) = (&options.runtime, options.device.is_some());
        let (owner, within) = match member {
            Some(_) => (format_ident!("Family"), (quote!(pub(in super::super)), quote!(pub(super)))),
            None => (marker.clone(), Default::default()),
        };
        let (member, unlike) = (member.unwrap_or(0), BTreeSet::new());
        Self {
            device,
            runtime,
            marker,
            owner,
            member,
            unlike,
            within,
            marker_is_outside,
            has_axes,
            objects,
            pdos,
            types,
            units,
        }
    }

    /// An item that is there for each axis, so far apart, or for the device.
    pub(super) fn placed<'s>(&'s self, item: Item<'s>, shift: Option<u16>) -> Item<'s> {
        match shift {
            Some(shift) => item.told(shift).of(&self.device.axes).using(Space::Root, &format_ident!("Axis")),
            None => item,
        }
    }

    /// The runtime's types of numbers that the device has.
    pub(super) fn widths(&self) -> BTreeSet<Primitive> {
        let entries = self.device.objects.iter().flat_map(|object| &object.entries);
        let mapped = self.device.pdos.iter().flat_map(|pdo| &pdo.entries);
        let of_entries = entries.map(|entry| Primitive::of(entry.data_type));
        let is_absent = |address| self.device.entry(address).is_none();
        let of_mapped = mapped
            .filter(|mapped| mapped.address.is_some_and(is_absent))
            .map(|mapped| mapped.data_type.map_or_else(|| Primitive::of_bits(mapped.bits), Primitive::of));
        of_entries.chain(of_mapped).filter(|primitive| !primitive.is_native()).collect()
    }

    /// The names of the axes, as variants and as variables.
    pub(super) fn axis_idents(&self) -> Vec<(Ident, Ident)> {
        let (mut variants, mut variables) = (Names::with(&["ALL"]), Names::default());
        let idents = self.device.axes.iter().map(|axis| {
            (variants.claim(&camel(&axis.name)), variables.claim(&snake(&format!("axis-{}", axis.name))))
        });
        idents.collect()
    }

    /// The name of a PDO's struct.
    pub(super) fn pdo_ident(&self, pdo: &Placed<'_, Pdo>) -> Ident {
        camel(&pdo.id)
    }
}
