//! The words by which a description refers to objects.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::numbered;
use crate::model::ids;
use crate::model::{Address, Coordinates, Index};
use crate::raw::{RawDevice, RawObject};
use crate::source::keys;
use crate::text::near::meant;

/// All objects that can be referred to, by id and by index, as they are on the first axis.
#[derive(Default)]
pub(super) struct Names {
    by_id: BTreeMap<String, Index>,
    /// Entries of objects that have several, by their own ids.
    by_entry: BTreeMap<String, Vec<Address>>,
    by_parameter: BTreeMap<String, Address>,
    known: Vec<Index>,
    /// What a profile has besides, by id.
    offered: Arc<BTreeMap<String, Index>>,
    coordinates: Option<Coordinates>,
}

impl Names {
    /// Gathers the ids of all described objects and the indices of what follows from the PDOs.
    pub(super) fn gather(raw: &RawDevice, coordinates: Option<Coordinates>) -> Self {
        let mut names = Self { coordinates, offered: Arc::clone(&raw.offered), ..Self::default() };
        for object in &raw.objects {
            let index = object.index;
            names.by_id.entry(object_id(object)).or_insert(index);
            names.by_parameter.extend(parameters(object));
            for (id, address) in entries(object) {
                names.by_entry.entry(id).or_default().push(address);
            }
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

    /// What `"controlword"`, `"0x6040"`, `"0x5010:03"` or `"software-position-limit:1"` refers to; an entry by its own id,
    /// `"max-position-limit"`, if no other has it.
    pub(super) fn find(&self, text: &str) -> Result<Address, Unknown> {
        if let Some(address) = self.by_parameter.get(text).copied().or_else(|| self.lying(text)) {
            return Ok(address);
        }
        let (object, subindex) = text.split_once(':').map_or((text, "0"), |(object, sub)| (object, sub));
        if let Some((index, subindex)) = self.object(object).zip(self::subindex(subindex)) {
            return Ok(Address { index, subindex });
        }
        match self.by_entry.get(text).map(Vec::as_slice) {
            Some([only]) => Ok(*only),
            Some(several) => Err(Unknown::Several(several.to_vec())),
            None => Err(Unknown::Nothing),
        }
    }

    /// The object that a reference names as a whole, and not one of its entries.
    pub(super) fn whole(&self, text: &str) -> Option<Index> {
        let is_entry = self.by_parameter.contains_key(text) || self.lying(text).is_some();
        self.object(text).filter(|_| !is_entry)
    }

    fn object(&self, text: &str) -> Option<Index> {
        match index(text) {
            Some(index) => Some(index).filter(|index| self.known.binary_search(index).is_ok()),
            None => self.by_id.get(text).copied(),
        }
    }

    /// The index of an object that a profile knows by this id, and the description does not mention.
    pub(super) fn offered(&self, id: &str) -> Option<Index> {
        self.offered.get(id).copied()
    }

    /// The object of a profile that the description does not mention and whose id goes on where one that refers to nothing
    /// ends, or is most like it.
    pub(super) fn near_offered(&self, id: &str) -> Option<(&str, Index)> {
        let id = ids::id(id);
        let ids = self.offered.keys().map(String::as_str);
        let longer = ids.clone().find(|offered| id.len() > 3 && offered.starts_with(&id));
        let name = longer.or_else(|| meant(&id, ids).map(|(name, _)| name))?;
        Some((name, self.offered(name)?))
    }

    /// The name of an object or an entry that is most like one that refers to nothing, and whether it is plain that it was
    /// meant.
    pub(super) fn near(&self, object: &str) -> Option<(String, bool)> {
        let names = self.by_id.keys().chain(self.by_entry.keys());
        meant(object, names.map(String::as_str)).map(|(name, is_plain)| (name.to_owned(), is_plain))
    }
}

/// Why a reference names nothing.
pub(super) enum Unknown {
    /// Several entries have this id.
    Several(Vec<Address>),
    Nothing,
}

/// The ids of an object's entries, but for their number.
fn entries(object: &RawObject) -> impl Iterator<Item = (String, Address)> {
    let index = object.index;
    let named = object.entries.iter().filter_map(|entries| Some((entries, entries.value.name.as_ref()?)));
    named.flat_map(move |(entries, name)| {
        let (first, last) = entries.range;
        (first.max(1)..=last).map(move |subindex| {
            let name = if entries.many { numbered::name(name, subindex) } else { name.to_owned() };
            (ids::id(&name), Address { index, subindex })
        })
    })
}

/// The parameters behind an object and its entries.
fn parameters(object: &RawObject) -> Vec<(String, Address)> {
    let index = object.index;
    let of_object = object.value.parameter.as_ref();
    let of_all = of_object.filter(|parameter| numbered::numbered(parameter, 1).is_some());
    let entries = object.entries.iter().filter_map(|entries| {
        let parameter = entries.value.parameter.as_ref().or(of_all)?;
        Some((entries.range, parameter))
    });
    let entries = entries.flat_map(|((first, last), parameter)| {
        let address = move |subindex| Address { index, subindex };
        (first..=last).map(move |subindex| (numbered::of(parameter, subindex), address(subindex)))
    });
    let own = of_object.filter(|_| of_all.is_none()).cloned();
    let own = own.map(|parameter| (parameter, Address { index, subindex: 0 }));
    entries.filter(|(_, address)| of_all.is_none() || address.subindex > 0).chain(own).collect()
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
