use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Address, Device, Index, Section};

rule! {
    /// 0x1C32:04 and 0x1C33:04 have a bit for each way to keep time (ETG.1020): bit 0 free run, bit 1 with the event of the
    /// sync manager, bits 2 to 4 with the clocks. A tool offers the ways of the ESI, and the device takes those of
    /// the object.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [objects.0x1C33]
    ///
    /// [objects.0x1C32.entries]
    /// 4 = { default = 0b0_0101 }
    ///
    /// [sync-modes.dc]
    /// name = "DC"
    /// assign-activate = 0x300
    /// sync0 = { cycles = 1 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [objects.0x1C33]
    ///
    /// [objects.0x1C32.entries]
    /// 4 = { default = 0b0_0101 }
    ///
    /// [sync-modes.dc]
    /// name = "DC"
    /// assign-activate = 0x300
    /// sync0 = { cycles = 1 }
    ///
    /// [sync-modes.free-run]
    /// name = "Free run"
    /// assign-activate = 0
    /// ```
    pub(super) static RULE = "contradicted-sync-types", ProcessData, Warning,
        "the dictionary supports other ways to keep time than there are";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    if device.sync_modes.is_empty() {
        return;
    }
    let free = device.sync_modes.iter().any(|mode| mode.assign_activate == 0);
    let clocked = device.sync_modes.iter().any(|mode| mode.assign_activate != 0);
    for index in [0x1C32, 0x1C33].map(Index) {
        let Some(entry) = device.entry(Address { index, subindex: 4 }) else { continue };
        let Some(types) = entry.default.as_ref().and_then(|default| default.integer()) else { continue };
        let ways = [
            (0b0_0011, free, "free run or synchronous with the sync manager", "`assign-activate = 0`"),
            (0b1_1100, clocked, "synchronous with the clocks", "another `assign-activate` than 0"),
        ];
        for (mask, described, way, mode) in ways {
            let fault = match (types & mask != 0, described) {
                (true, false) => format!("{} says {way}, but no sync mode has {mode}", entry.address),
                (false, true) => format!("a sync mode has {mode}, but {} does not say {way}", entry.address),
                _ => continue,
            };
            let diagnostic =
                Diagnostic::new(&RULE, fault, entry.origin.value("default"), "the types supported");
            let first = device.sync_modes.first().map(|mode| mode.origin.header());
            let diagnostic = first.into_iter().fold(diagnostic, |it, at| it.label(at, "the sync modes"));
            report.push(
                entry.address,
                diagnostic.note(format!("`[{}]` lists them", Section::SyncModes.name())),
            );
        }
    }
}
