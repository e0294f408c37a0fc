//! Defaults that say once more what is said elsewhere: devc makes them of that.

use super::super::read::{Device, Esi};
use super::super::toml::{Toml, get};
use super::described::Described;
use crate::model::DataType;

/// Leaves defaults out that follow: those of 0x1018 from the identity, and that of 0x1000 from the profile of several axes.
pub(super) fn leave_out(described: &mut [Described], esi: &Esi, device: &Device, axes: usize) {
    let head = &device.head;
    let kind = device.profile.filter(|profile| axes > 1 && *profile <= 0xFFFF);
    for object in described {
        for value in object.values.iter_mut().filter(|value| value.data_type == DataType::Uint(32)) {
            let follows = match (object.index, value.subindex) {
                (0x1000, 0) => kind.map(|profile| SEVERAL << 16 | profile),
                (0x1018, 1) => esi.vendor_id,
                (0x1018, 2) => head.product_code,
                (0x1018, 3) => Some(head.revision),
                _ => None,
            };
            let follows = follows.map(u64::from);
            let is_said = match get(&value.keys, "default") {
                Some(Toml::Hex(said, _)) => Some(*said) == follows,
                Some(Toml::Integer(said)) => Some(*said) == follows.map(i128::from),
                _ => false,
            };
            if is_said {
                value.keys.retain(|(name, _)| name != "default");
            }
        }
    }
}

/// The additional information of a device with several axes, CiA 301.
const SEVERAL: u32 = 0xFFFF;
