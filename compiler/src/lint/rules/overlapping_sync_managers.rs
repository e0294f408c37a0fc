use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section, SyncManager};

rule! {
    /// Each sync manager has its own part of the memory. One with three buffers, as process data has, takes three
    /// times its length; where two meet, one writes over the other.
    ///
    /// The length that counts is the longest that the area can get.
    ///
    /// ## Fires
    /// ```toml
    /// [sync-managers]
    /// outputs = { address = 0x1100, max-size = 32 }
    /// inputs = { address = 0x1140, max-size = 32 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [sync-managers]
    /// outputs = { address = 0x1100, max-size = 32 }
    /// inputs = { address = 0x1160, max-size = 32 }
    /// ```
    pub(super) static RULE = "overlapping-sync-managers", ProcessData, Warning,
        "two sync managers share memory";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (i, first) in device.sync_managers.iter().enumerate() {
        for second in device.sync_managers.iter().skip(i + 1) {
            let (low, high) = if first.address <= second.address { (first, second) } else { (second, first) };
            let (end, begin) = (low.end(), u32::from(high.address));
            if low.longest() == 0 || high.longest() == 0 || end <= begin {
                continue;
            }
            let message =
                format!("`{}` ends at 0x{end:04X}, but `{}` begins at 0x{begin:04X}", &low.id, &high.id);
            let diagnostic = Diagnostic::new(&RULE, message, high.origin.value("address"), "begins here")
                .label(low.origin.value("address"), extent(low));
            report.push(Section::SyncManagers.at(&high.id), diagnostic);
        }
    }
}

fn extent(manager: &SyncManager) -> String {
    match manager.buffers() {
        1 => format!("{} bytes from here", manager.longest()),
        buffers => format!("{buffers} × {} bytes from here", manager.longest()),
    }
}
