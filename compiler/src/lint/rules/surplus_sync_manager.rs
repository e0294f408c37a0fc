use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// SOES serves four sync managers: a mailbox in each direction, and one area of process data in each. What a further
    /// one carries, it neither sends nor takes.
    ///
    /// ## Fires
    /// ```toml
    /// [sync-managers]
    /// mailbox-out = { address = 0x1000, size = 128 }
    /// mailbox-in = { address = 0x1080, size = 128 }
    /// outputs = { address = 0x1100 }
    /// inputs = { address = 0x1400 }
    /// slow = { role = "inputs", address = 0x1500 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [sync-managers]
    /// mailbox-out = { address = 0x1000, size = 128 }
    /// mailbox-in = { address = 0x1080, size = 128 }
    /// outputs = { address = 0x1100 }
    /// inputs = { address = 0x1400 }
    /// ```
    pub(crate) static RULE = "surplus-sync-manager", Output, Warning,
        "there are more sync managers of a kind than SOES serves";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut first = BTreeMap::new();
    for manager in &device.sync_managers {
        let Some(other) = first.get(&manager.role) else {
            first.insert(manager.role, manager);
            continue;
        };
        let message = format!("`{}` and `{}` carry data in the same direction", other.id, manager.id);
        let diagnostic = Diagnostic::new(&RULE, message, manager.origin.header(), "is not served by SOES")
            .label(other.origin.header(), "is served");
        report.push(Section::SyncManagers.at(&manager.id), diagnostic);
    }
}
