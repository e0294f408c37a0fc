//! The words by which a description refers to objects.

use std::collections::BTreeMap;

use super::numbered;
use crate::model::ids;
use crate::model::{Address, Coordinates, Index};
use crate::raw::{RawDevice, RawObject};
use crate::source::keys;
use crate::text::near::near;

/// All objects that can be referred to, by id and by index, as they are on the first axis.
#[derive(Default)]
pub(super) struct Names {
    by_id: BTreeMap<String, Index>,
    by_parameter: BTreeMap<String, Address>,
    known: Vec<Index>,
    coordinates: Option<Coordinates>,
}

impl Names {
    /// Gathers the ids of all described objects and the indices of what follows from the PDOs.
    pub(super) fn gather(raw: &RawDevice, coordinates: Option<Coordinates>) -> Self {
        let mut names = Self { coordinates, ..Self::default() };
        for object in &raw.objects {
            let index = object.index;
            names.by_id.entry(object_id(object)).or_insert(index);
            names.by_parameter.extend(parameters(object));
            names.known.push(index);
        }
        for pdo in raw.rx_pdos.iter().chain(&raw.tx_pdos) {
            names.known.extend(index(&pdo.key));
        }
        names.known.extend([0x1C00, 0x1C12, 0x1C13].map(Index));
        names.known.sort();
        names
    }

    /// The address that a coordinate of the vendor stands for by the formula.
    pub(super) fn coordinate(&self, text: &str) -> Option<Address> {
        self.coordinates.as_ref()?.address(text)
    }

    /// The vendor's numbering.
    pub(super) fn coordinates(&self) -> Option<Coordinates> {
        self.coordinates.clone()
    }

    /// The address of a coordinate at which an object is described.
    fn lying(&self, text: &str) -> Option<Address> {
        self.coordinate(text).filter(|address| self.known.binary_search(&address.index).is_ok())
    }

    /// What `"controlword"`, `"0x6040"`, `"0x5010:03"` or `"software-position-limit:1"` refers to.
    pub(super) fn find(&self, text: &str) -> Option<Address> {
        if let Some(address) = self.by_parameter.get(text).copied().or_else(|| self.lying(text)) {
            return Some(address);
        }
        let (object, subindex) = text.split_once(':').map_or((text, "0"), |(object, sub)| (object, sub));
        let index = match index(object) {
            Some(index) => Some(index).filter(|index| self.known.binary_search(index).is_ok()),
            None => self.by_id.get(object).copied(),
        };
        let subindex = self::subindex(subindex);
        index.zip(subindex).map(|(index, subindex)| Address { index, subindex })
    }

    /// The word for an object that is most like one that refers to nothing.
    pub(super) fn near(&self, text: &str) -> Option<String> {
        let object = text.split(':').next().unwrap_or(text);
        near(object, self.by_id.keys().map(String::as_str)).map(str::to_owned)
    }
}

/// The parameters behind an object and its entries.
fn parameters(object: &RawObject) -> Vec<(String, Address)> {
    let index = object.index;
    let entries =
        object.entries.iter().filter_map(|entries| Some((entries.range, entries.value.parameter.as_ref()?)));
    let entries = entries.flat_map(|((first, last), parameter)| {
        let address = move |subindex| Address { index, subindex };
        (first..=last).map(move |subindex| (numbered::of(parameter, subindex), address(subindex)))
    });
    let own = object.value.parameter.clone().map(|parameter| (parameter, Address { index, subindex: 0 }));
    entries.chain(own).collect()
}

/// The subindex of a reference: hexadecimal, as ETG and CiA print it.
pub(super) fn subindex(text: &str) -> Option<u8> {
    u8::from_str_radix(text.strip_prefix("0x").unwrap_or(text), 16).ok().filter(|_| !text.starts_with('+'))
}

/// The index that a key such as `0x6040` stands for.
pub(super) fn index(key: &str) -> Option<Index> {
    key.strip_prefix("0x").and_then(|_| keys::number(key)).and_then(|n| u16::try_from(n).ok()).map(Index)
}

/// The word for an object: its id, or its name in kebab case, or its index.
pub(super) fn object_id(object: &RawObject) -> String {
    let id = object.head.id.clone();
    id.or_else(|| object.value.name.as_deref().map(ids::id)).unwrap_or_else(|| object.key.clone())
}
