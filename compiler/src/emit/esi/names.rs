//! The names of what PDOs carry.

use crate::model::{Device, Mapped, Pdo};

/// The name of what a PDO carries, with the axis of the object; what the dictionary lacks is of the PDO's axis.
pub(super) fn mapped(device: &Device, pdo: &Pdo, mapped: &Mapped) -> String {
    let object = mapped.address.and_then(|address| device.object(address.index));
    device.on_axis(&mapped.name, object.map_or(pdo.axis, |object| object.axis))
}
