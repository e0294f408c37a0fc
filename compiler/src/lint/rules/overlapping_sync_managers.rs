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
    /// outputs = { address = 0x1100, size = 32 }
    /// inputs = { address = 0x1140, size = 32 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [sync-managers]
    /// outputs = { address = 0x1100, size = 32 }
    /// inputs = { address = 0x1160, size = 32 }
    /// ```
    pub(super) static RULE = "overlapping-sync-managers", ProcessData, Warning,
        "two sync managers share memory";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (i, first) in device.sync_managers.iter().enumerate() {
        for second in device.sync_managers.iter().skip(i + 1) {
            let (low, high) = if first.address <= second.address { (first, second) } else { (second, first) };
            let (end, begin) = (end(low), u32::from(high.address));
            if bytes(low) == 0 || bytes(high) == 0 || end <= begin {
                continue;
            }
            let message = format!(
                "`{}` ends at 0x{end:04X}, but `{}` begins at 0x{begin:04X}",
                low.role.key(),
                high.role.key()
            );
            let diagnostic = Diagnostic::new(&RULE, message, high.origin.value("address"), "begins here")
                .label(low.origin.value("address"), extent(low));
            report.push(Section::SyncManagers.at(high.role.key()), diagnostic);
        }
    }
}

/// The longest the area of one buffer can get.
fn bytes(manager: &SyncManager) -> u32 {
    u32::from(manager.max_size.unwrap_or(manager.size).max(manager.size))
}

/// How many buffers the control byte asks for: bits 0 and 1 are 2 for a mailbox, 0 for process data.
fn buffers(manager: &SyncManager) -> u32 {
    if manager.control & 0x03 == 0 { 3 } else { 1 }
}

fn end(manager: &SyncManager) -> u32 {
    u32::from(manager.address) + buffers(manager) * bytes(manager)
}

fn extent(manager: &SyncManager) -> String {
    match buffers(manager) {
        1 => format!("{} bytes from here", bytes(manager)),
        buffers => format!("{buffers} × {} bytes from here", bytes(manager)),
    }
}
