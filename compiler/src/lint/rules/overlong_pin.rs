use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Mapped};

rule! {
    /// LinuxCNC knows process data as pins of HAL, whose names have 47 characters. `lcec`, the master and the slave stand in
    /// front, so 37 are left for axis and name of a value. A longer one is cut, and says less.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Position of the second encoder, filtered"
    /// type = "INT32"
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
    /// name = "Position of the second encoder, filtered"
    /// id = "second-position"
    /// type = "INT32"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// ```
    pub(crate) static RULE = "overlong-pin", Output, Warning, "a name does not fit into a pin of LinuxCNC";
}

/// The characters of a pin behind `lcec.0.10.`, of the 47 that `HAL_NAME_LEN` allows.
pub(crate) const LONGEST: usize = 37;

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut known = BTreeSet::new();
    for (_, place, mapped) in lookup::mapped(device) {
        let length = name(device, mapped).map_or(0, |name| name.len());
        // the same value can be in several PDOs
        if length <= LONGEST || !mapped.address.is_some_and(|address| known.insert(address)) {
            continue;
        }
        let message = format!("a pin for `{}` has {length} characters; {LONGEST} fit", mapped.name);
        let diagnostic = Diagnostic::new(&RULE, message, mapped.origin.header(), "is cut in LinuxCNC");
        report.push(place, diagnostic.help("give the object a shorter `id`"));
    }
}

/// The axis where there are several, and the id.
fn name(device: &Device, mapped: &Mapped) -> Option<String> {
    let axis = device.object(mapped.address?.index)?.axis.filter(|_| device.axes.len() > 1);
    let axis = axis.and_then(|axis| device.axes.get(usize::from(axis)));
    Some(axis.map_or(mapped.id.clone(), |axis| format!("{}-{}", axis.name, mapped.id)))
}
