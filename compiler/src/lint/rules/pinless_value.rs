use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{DataType, Device, Mapped};

rule! {
    /// A pin of LinuxCNC is a bit, a whole number of 32 bits or a number with a fraction. What is wider, or no number, is
    /// mapped so that all else lies where it should, but a machine cannot reach it.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Steps since the start"
    /// type = "UINT64"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Steps since the start"
    /// type = "UINT32"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// ```
    pub(crate) static RULE = "pinless-value", Output, Warning, "a value that is mapped has no pin in LinuxCNC";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut known = BTreeSet::new();
    for (_, place, mapped) in lookup::mapped(device) {
        if is_held(mapped) || !mapped.address.is_some_and(|address| known.insert(address)) {
            continue;
        }
        let message = format!("`{}` has {} bits, and no pin holds it", mapped.name, mapped.bits);
        report.push(place, Diagnostic::new(&RULE, message, mapped.origin.header(), "has no pin in LinuxCNC"));
    }
}

fn is_held(mapped: &Mapped) -> bool {
    match mapped.data_type {
        Some(data_type @ (DataType::Real32 | DataType::Real64)) => data_type.bits() == mapped.bits,
        Some(DataType::Text(_) | DataType::Octets(_) | DataType::Unicode(_)) => false,
        _ => mapped.bits <= 32,
    }
}
