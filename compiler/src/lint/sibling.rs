//! What rules compare between the members of a family.

use super::occupant::Occupant;
use crate::model::{Address, Device, Identity, Index, Pdo};

/// A member of the family that was looked at before.
#[derive(Debug, Clone)]
pub(crate) struct Sibling {
    /// The word for it.
    pub(crate) id: String,
    pub(crate) identity: Identity,
    pub(crate) image: Image,
    /// What is in the first slot of each of its modules.
    pub(crate) occupants: Vec<Occupant>,
}

/// What a master sees of the process data: each PDO with the entries and bits that it carries.
pub(crate) type Image = Vec<(Index, Vec<(Option<Address>, u32)>)>;

impl Sibling {
    /// What there is to compare of a device.
    pub(super) fn new(device: &Device) -> Self {
        let occupants = device.modules.iter().filter_map(|module| {
            let axis = device.axes_of(module).next()?;
            Some(Occupant::new(device, module, axis))
        });
        Self {
            id: device.id.clone(),
            identity: device.identity.clone(),
            image: image(device),
            occupants: occupants.collect(),
        }
    }
}

/// The process data of a device.
pub(super) fn image(device: &Device) -> Image {
    let carried = |pdo: &Pdo| pdo.entries.iter().map(|mapped| (mapped.address, mapped.bits)).collect();
    device.pdos.iter().map(|pdo| (pdo.index, carried(pdo))).collect()
}
