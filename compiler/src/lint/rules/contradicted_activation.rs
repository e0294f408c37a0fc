use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section, SyncMode};

rule! {
    /// `assign-activate` is what a master writes to the registers 0x980 and 0x981 (ETG.1000.4): bit 8 starts the unit that
    /// makes the signals, bit 9 lets it make SYNC0, bit 10 SYNC1, which comes so long after a pulse of SYNC0. Signals are
    /// described where they are made, and made where they are described.
    ///
    /// ## Fires
    /// ```toml
    /// [objects]
    /// 0x1C32 = { name = "Outputs", type = "UINT16" }
    /// 0x1C33 = { name = "Inputs", type = "UINT16" }
    ///
    /// [sync-modes.dc]
    /// name = "DC"
    /// assign-activate = 0x300
    /// sync0 = { cycles = 1 }
    /// sync1 = { cycles = 2 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects]
    /// 0x1C32 = { name = "Outputs", type = "UINT16" }
    /// 0x1C33 = { name = "Inputs", type = "UINT16" }
    ///
    /// [sync-modes.dc]
    /// name = "DC"
    /// assign-activate = 0x700
    /// sync0 = { cycles = 1 }
    /// sync1 = { cycles = 2 }
    /// ```
    pub(super) static RULE = "contradicted-activation", ProcessData, Warning,
        "the signals of the clocks are not those that are started";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for mode in &device.sync_modes {
        for (key, fault) in faults(mode) {
            let at = mode.origin.value("assign-activate");
            let value = mode.assign_activate;
            let diagnostic =
                Diagnostic::new(&RULE, format!("`{}`: {fault}", mode.id), at, format!("0x{value:03X}"));
            let other = key.filter(|key| mode.origin.has(key)).map(|key| mode.origin.value(key));
            let diagnostic = match other {
                Some(other) => diagnostic.label(other, "described here"),
                None => diagnostic,
            };
            report.push(Section::SyncModes.at(&mode.id), diagnostic);
        }
    }
}

/// What the register says otherwise than the signals, and which of them.
fn faults(mode: &SyncMode) -> Vec<(Option<&'static str>, &'static str)> {
    let set = |bit: u16| mode.assign_activate & (1 << bit) != 0;
    let made = set(9) || set(10);
    let checks = [
        (set(9) && mode.sync0.is_none(), None, "bit 9 makes SYNC0, which is not described"),
        (!set(9) && mode.sync0.is_some(), Some("sync0"), "SYNC0 is described, but bit 9 does not make it"),
        (set(10) && mode.sync1.is_none(), None, "bit 10 makes SYNC1, which is not described"),
        (!set(10) && mode.sync1.is_some(), Some("sync1"), "SYNC1 is described, but bit 10 does not make it"),
        (
            set(10) && !set(9) && mode.sync1.is_some() && mode.sync0.is_none(),
            Some("sync1"),
            "SYNC1 follows the pulses of SYNC0, which bit 9 does not make",
        ),
        (made && !set(8), None, "signals are made, but bit 8 does not start the unit that makes them"),
        (set(8) && !made, None, "bit 8 starts a unit that makes no signal"),
    ];
    checks.into_iter().filter(|(wrong, ..)| *wrong).map(|(_, key, fault)| (key, fault)).collect()
}
