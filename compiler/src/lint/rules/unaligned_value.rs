use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{DataType, Device, Mapped};

rule! {
    /// A struct of Structured Text that lies over process data has whole bytes in it, and numbers of 8, 16, 32 and 64 bits. A
    /// value that begins or ends within a byte, a text and a number of another width are bytes there, from which a program
    /// takes it apart.
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
    pub(crate) static RULE = "unaligned-value", Output, Warning,
        "a value that is mapped is no number in a struct of Structured Text";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut known = BTreeSet::new();
    for (_, place, mapped) in lookup::mapped(device) {
        if is_number(mapped) || !mapped.address.is_some_and(|address| known.insert(address)) {
            continue;
        }
        let message = format!("`{}` has {} bits from bit {} on", mapped.name, mapped.bits, mapped.offset);
        report.push(
            place,
            Diagnostic::new(&RULE, message, mapped.origin.header(), "is bytes in Structured Text"),
        );
    }
}

fn is_number(mapped: &Mapped) -> bool {
    let is_whole = mapped.offset.is_multiple_of(8) && matches!(mapped.bits, 8 | 16 | 32 | 64);
    let has_number = !matches!(
        mapped.data_type,
        Some(DataType::Text(_) | DataType::Octets(_) | DataType::Unicode(_) | DataType::Array(..))
    );
    is_whole && has_number && mapped.data_type.is_none_or(|it| it.bits() == mapped.bits)
}
