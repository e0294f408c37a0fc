use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section, SyncSignal};

rule! {
    /// The period of a signal is a number of cycles or a time, not both; and an ESI has room for times of less than 2.2
    /// seconds, in nanoseconds.
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
    /// sync0 = { cycles = 2, period = "1 ms" }
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
    /// assign-activate = 0x300
    /// sync0 = { period = "1 ms", shift = "-20 us" }
    /// ```
    pub(crate) static RULE = "contradicted-period", Output, Warning,
        "a signal of the clocks has two periods, or one that is too long";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for mode in &device.sync_modes {
        let signals = [("sync0", &mode.sync0), ("sync1", &mode.sync1)];
        for (key, signal) in signals.into_iter().filter_map(|(key, signal)| Some((key, signal.as_ref()?))) {
            let cycles = mode.origin.has(&format!("{key}.cycles"));
            if let Some((part, fault)) = judge(signal, cycles) {
                let at = mode.origin.value(&format!("{key}.{part}"));
                let diagnostic =
                    Diagnostic::new(&RULE, format!("`{key}` of `{}` {fault}", mode.id), at, "here");
                report.push(Section::SyncModes.at(&mode.id).at(key), diagnostic);
            }
        }
    }
}

fn judge(signal: &SyncSignal, cycles: bool) -> Option<(&'static str, &'static str)> {
    let long = |time: u64| time > i32::MAX.unsigned_abs().into();
    match signal.period {
        Some(_) if cycles => Some(("period", "comes every so many cycles and at a time of its own")),
        Some(period) if long(period.0) => Some(("period", "has a period longer than an ESI can tell")),
        _ if long(signal.shift.0.unsigned_abs()) => {
            Some(("shift", "is shifted by more than an ESI can tell"))
        }
        _ => None,
    }
}
