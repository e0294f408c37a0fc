use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{DataType, Device, Mapped};

rule! {
    /// A channel of `ethercat_driver_ros2` is a bit or a whole number of 8, 16, 32 or 64 bits. Numbers with a fraction, texts
    /// and other widths are mapped so that all else lies where it should, but a controller cannot reach them.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Temperature"
    /// type = "REAL32"
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
    /// name = "Temperature"
    /// type = "INT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// ```
    pub(crate) static RULE = "channelless-value", Output, Warning, "a value that is mapped has no channel in ROS 2";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut known = BTreeSet::new();
    for (_, place, mapped) in lookup::mapped(device) {
        if is_held(mapped) || !mapped.address.is_some_and(|address| known.insert(address)) {
            continue;
        }
        let message = format!("`{}` is nothing that a channel of ROS 2 holds", mapped.name);
        report.push(
            place,
            Diagnostic::new(&RULE, message, mapped.origin.header(), "cannot be reached in ROS 2"),
        );
    }
}

fn is_held(mapped: &Mapped) -> bool {
    let whole = matches!(mapped.bits, 1 | 8 | 16 | 32 | 64);
    match mapped.data_type {
        Some(DataType::Real32 | DataType::Real64) => false,
        Some(DataType::Text(_) | DataType::Octets(_) | DataType::Unicode(_)) => false,
        _ => whole,
    }
}
