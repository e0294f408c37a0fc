use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Address, Device, Entry, Index, Role, Section, SyncMode};

rule! {
    /// 0x1C32:04 and 0x1C33:04 have a bit for each way to keep time (ETG.1020): bit 0 free run, bit 1 with the event of the
    /// sync manager, bits 2 to 4 with the clocks. A tool offers the ways of the ESI, and the device takes those of
    /// the object. So it is with the `sync-type` that a way gives a sync manager.
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
    for index in OBJECTS {
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
        for mode in &device.sync_modes {
            chosen(device, mode, (entry, types), report);
        }
    }
}

/// The types that a way to keep time gives a sync manager, and the object of it does not support.
fn chosen(device: &Device, mode: &SyncMode, (entry, types): (&Entry, i128), report: &mut Report) {
    for chosen in mode.managers.iter() {
        let manager = device.sync_managers.iter().find(|manager| manager.id == chosen.id);
        let object = manager.and_then(|manager| match manager.role {
            Role::Outputs => Some(OBJECTS[0]),
            Role::Inputs => Some(OBJECTS[1]),
            Role::MailboxOut | Role::MailboxIn => None,
        });
        let Some(kind) = chosen.sync_type.filter(|_| object == Some(entry.address.index)) else { continue };
        let Some(mask) = bits(kind).filter(|mask| types & mask == 0) else { continue };
        let message = format!(
            "`{}` has the type of synchronisation {kind}, which {} does not support",
            mode.id, entry.address
        );
        let key = format!("managers.{}.sync-type", chosen.id);
        let bits = lookup::list((0..8).filter(|bit| mask >> bit & 1 == 1));
        let diagnostic = Diagnostic::new(&RULE, message, mode.origin.value(&key), "the type")
            .label(entry.origin.value("default"), format!("without bit {}", bits.replace(", ", " or ")));
        report.push(Section::SyncModes.at(&mode.id).at(key), diagnostic);
    }
}

/// The bits of the types supported of which one is set where subindex 1 can have a value. A device that follows a fixed
/// SYNC0 has bit 4, whichever of the signals it then is.
fn bits(kind: u16) -> Option<i128> {
    match kind {
        0 => Some(0b0_0001),
        1 | 0x22 => Some(0b0_0010),
        2 => Some(0b1_0100),
        3 => Some(0b1_1000),
        _ => None,
    }
}

/// What tells how outputs and inputs keep time.
const OBJECTS: [Index; 2] = [Index(0x1C32), Index(0x1C33)];
