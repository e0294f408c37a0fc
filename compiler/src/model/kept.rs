//! Which values a firmware keeps, and which are constants of its code.

use super::{Access, DataType, Device, Entry, Object, Provenance, provenance};

impl Device {
    /// Whether the value can change, so that a firmware keeps it: not if its access says that it never does, or if it
    /// follows from the PDOs or from the number of entries. A mapping that is not fixed changes even if not by the
    /// mailbox.
    pub fn keeps(&self, object: &Object, entry: &Entry) -> bool {
        let is_free = self.pdo(object.index).is_some_and(|pdo| !pdo.fixed);
        let is_derived = || provenance(&entry.origin, "type") == Provenance::Derived;
        match entry.access {
            Access::Const => false,
            Access::Ro => (is_free || !is_derived()) && !matches!(entry.data_type, DataType::Text(0)),
            Access::Wo | Access::Rw => true,
        }
    }
}
