//! How parts of a device are numbered and named: as in the device, or as in the slot of an axis.

use super::element::Element;
use super::literal::Hex;
use crate::model::{Device, Index, Object, Pdo};

/// What a part of the ESI is part of.
#[derive(Debug, Clone, Copy)]
pub(super) enum Frame<'d> {
    /// The device.
    Device(&'d Device),
    /// The module in the slot of an axis: indices are those of the first slot.
    Slot(&'d Device, u8),
}

impl<'d> Frame<'d> {
    pub(super) fn device(self) -> &'d Device {
        match self {
            Self::Device(device) | Self::Slot(device, _) => device,
        }
    }

    fn slot(self) -> Option<u8> {
        match self {
            Self::Device(_) => None,
            Self::Slot(_, axis) => Some(axis),
        }
    }

    /// Whether an object stands here.
    pub(super) fn has(self, object: &Object) -> bool {
        self.device().slot_of(object) == self.slot()
    }

    /// Whether a PDO stands here.
    pub(super) fn carries(self, pdo: &Pdo) -> bool {
        pdo.axis.filter(|_| !self.device().modules.is_empty()) == self.slot()
    }

    /// The index of an object, which says whether it depends on the slot.
    pub(super) fn object(self, index: Index) -> Element {
        match self.slot().and_then(|axis| self.device().index_in_slot(axis, index)) {
            Some(leading) => dependent("Index", leading),
            None => Element::leaf("Index", Hex(index.0)),
        }
    }

    /// The index of a PDO, which says whether it depends on the slot.
    pub(super) fn pdo(self, tag: &'static str, index: Index) -> Element {
        match self.device().pdo(index).filter(|pdo| pdo.axis.is_some() && pdo.axis == self.slot()) {
            Some(pdo) => dependent(tag, pdo.leading),
            None => Element::leaf(tag, Hex(index.0)),
        }
    }

    /// A name, with the axis behind it where there are several.
    pub(super) fn name(self, name: &str, axis: Option<u8>) -> String {
        self.device().on_axis(name, axis.filter(|_| axis != self.slot()))
    }
}

fn dependent(tag: &'static str, index: Index) -> Element {
    Element::leaf(tag, Hex(index.0)).with("DependOnSlot", 1)
}
