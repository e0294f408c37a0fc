use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// An ESI does not number sync managers: the first is 0, the next 1, and what refers to one counts. So a number is
    /// a place, each is taken once, and none is left out. What the device does not use is described, too, with
    /// `enable = false`. A controller has 16 of them at most (ETG.1000.4).
    ///
    /// ## Fires
    /// ```toml
    /// [sync-managers]
    /// mailbox-out = { address = 0x1000, size = 128 }
    /// mailbox-in = { address = 0x1080, size = 128 }
    /// inputs = { number = 3, address = 0x1100 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [sync-managers]
    /// mailbox-out = { address = 0x1000, size = 128 }
    /// mailbox-in = { address = 0x1080, size = 128 }
    /// outputs = { address = 0x1100, enable = false }
    /// inputs = { number = 3, address = 0x1100 }
    /// ```
    pub(super) static RULE = "misplaced-sync-manager", ProcessData, Error,
        "the number of a sync manager is not its place";
}

/// How many sync managers a controller can have.
const MOST: usize = 16;

pub(super) fn check(device: &Device, report: &mut Report) {
    if let Some(first) = device.sync_managers.iter().filter(|manager| !manager.r#virtual).nth(MOST) {
        let message = format!("`{}` is one more than the {MOST} that a controller can have", first.id);
        let diagnostic = Diagnostic::new(&RULE, message, first.origin.header(), "has no registers");
        report.push(Section::SyncManagers.at(&first.id), diagnostic);
    }
    let numbers = device.sync_managers.iter().filter_map(|manager| {
        let node = manager.origin.node("number")?;
        match node.value {
            crate::source::Value::Integer(number) => Some((manager, number, node.at)),
            _ => None,
        }
    });
    for (manager, number, at) in numbers.filter(|(manager, number, _)| *number != manager.number.into()) {
        let message = format!("`{}` is number {number}, but at place {}", manager.id, manager.number);
        let diagnostic = match device.sync_managers.iter().find(|other| i128::from(other.number) == number) {
            Some(other) => Diagnostic::new(&RULE, message, at, "another one is at this place")
                .label(other.origin.header(), format!("number {number}")),
            None => Diagnostic::new(&RULE, message, at, "a number before it is left out")
                .help("describe the sync manager between, with `enable = false` if it is not used"),
        };
        report.push(Section::SyncManagers.at(&manager.id), diagnostic);
    }
}
