use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{DataType, Device};

rule! {
    /// SOES copies bits, whole numbers of 8, 16, 32 and 64 bits and numbers with a fraction between objects and process
    /// data. Texts and numbers of other widths can be read and written as SDOs; in process data they stay zero.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position"
    /// type = "INT24"
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
    /// name = "Position"
    /// type = "INT32"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// ```
    pub(crate) static RULE = "uncopied-value", Output, Warning, "a value that is mapped is not copied by SOES";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut known = BTreeSet::new();
    for (_, place, mapped) in lookup::mapped(device) {
        let is_copied = mapped.data_type.is_none_or(is_copied);
        if is_copied || !mapped.address.is_some_and(|address| known.insert(address)) {
            continue;
        }
        let message = format!("`{}` is nothing that SOES copies", mapped.name);
        report.push(
            place,
            Diagnostic::new(&RULE, message, mapped.origin.header(), "stays zero in process data"),
        );
    }
}

fn is_copied(data_type: DataType) -> bool {
    match data_type {
        DataType::Bool | DataType::Bits(_) | DataType::Bitstring(_) | DataType::Real32 | DataType::Real64 => {
            true
        }
        DataType::Int(bits) | DataType::Uint(bits) => matches!(bits, 8 | 16 | 32 | 64),
        DataType::Text(_) | DataType::Octets(_) | DataType::Unicode(_) | DataType::Array(..) => false,
    }
}
