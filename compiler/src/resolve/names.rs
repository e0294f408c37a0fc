//! The words by which a description refers to objects.

use std::collections::BTreeMap;

use super::{ids, keys};
use crate::model::{Address, Index};
use crate::raw::{ObjectEntity, RawDevice};
use crate::source::near::near;

/// All objects that can be referred to, by id and by index, as they are on the first axis.
#[derive(Default)]
pub(super) struct Names {
    by_id: BTreeMap<String, Index>,
    known: Vec<Index>,
}

impl Names {
    /// Gathers the ids of all described objects and the indices of what follows from the PDOs.
    pub(super) fn gather(raw: &RawDevice) -> Self {
        let mut names = Self::default();
        for object in &raw.objects {
            if let Some(index) = index(&object.object.key) {
                names.by_id.entry(object_id(object)).or_insert(index);
                names.known.push(index);
            }
        }
        for pdo in raw.rx_pdos.iter().chain(&raw.tx_pdos) {
            names.known.extend(index(&pdo.key));
        }
        names.known.extend([0x1C00, 0x1C12, 0x1C13].map(Index));
        names.known.sort();
        names
    }

    /// What `"controlword"`, `"0x6040"`, `"0x5010:03"` or `"software-position-limit:1"` refers to; the near
    /// word if there is none.
    pub(super) fn find(&self, text: &str) -> Result<Address, Option<String>> {
        let (object, subindex) = text.split_once(':').map_or((text, "0"), |(object, sub)| (object, sub));
        let index = match index(object) {
            Some(index) => Some(index).filter(|index| self.known.binary_search(index).is_ok()),
            None => self.by_id.get(object).copied(),
        };
        let subindex = subindex_of(subindex);
        index
            .zip(subindex)
            .map(|(index, subindex)| Address { index, subindex })
            .ok_or_else(|| near(object, self.by_id.keys().map(String::as_str)).map(str::to_owned))
    }
}

/// The subindex of a reference: two hexadecimal digits as manuals print them, or a number.
fn subindex_of(text: &str) -> Option<u8> {
    if text.len() == 2 && text.starts_with('0') {
        return u8::from_str_radix(text, 16).ok();
    }
    keys::number(text).and_then(|number| u8::try_from(number).ok())
}

/// The index that a key such as `0x6040` stands for.
pub(super) fn index(key: &str) -> Option<Index> {
    key.strip_prefix("0x").and_then(|_| keys::number(key)).and_then(|n| u16::try_from(n).ok()).map(Index)
}

/// The word for an object: its id, or its name in kebab case, or its index.
pub(super) fn object_id(object: &ObjectEntity) -> String {
    let id = object.object.raw.id.clone();
    id.or_else(|| object.value.name.as_deref().map(ids::id)).unwrap_or_else(|| object.object.key.clone())
}
