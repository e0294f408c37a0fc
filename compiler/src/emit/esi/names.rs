//! The names of what PDOs carry.

use super::frame::Frame;
use crate::model::{Mapped, Pdo};

/// The name of what a PDO carries, with the axis of the object; what the dictionary lacks is of the PDO's axis.
pub(super) fn mapped(frame: Frame<'_>, pdo: &Pdo, mapped: &Mapped) -> String {
    let object = mapped.address.and_then(|address| frame.device().object(address.index));
    frame.name(&mapped.name, object.map_or(pdo.axis, |object| object.axis))
}
