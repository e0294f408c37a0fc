use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// A signal that comes every millisecond comes at the same times whether it is shifted by 1.2 ms or by 0.2 ms. So a shift is
    /// no longer than the period, or one of the two is in another unit than was meant.
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
    /// sync0 = { period = "1 ms", shift = "20 ms" }
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
    /// sync0 = { period = "1 ms", shift = "20 us" }
    /// ```
    pub(super) static RULE = "overlong-shift", ProcessData, Warning,
        "a signal of the clocks is shifted by more than its period";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for mode in &device.sync_modes {
        for (key, signal) in [("sync0", &mode.sync0), ("sync1", &mode.sync1)] {
            let Some(signal) = signal else { continue };
            if signal.period.is_none_or(|period| signal.shift.0.unsigned_abs() <= period.0) {
                continue;
            }
            let message = format!("`{key}` of `{}` is shifted by more than its period", mode.id);
            let at = mode.origin.value(&format!("{key}.shift"));
            let diagnostic = Diagnostic::new(&RULE, message, at, "the shift")
                .label(mode.origin.value(&format!("{key}.period")), "comes again after this time");
            report.push(Section::SyncModes.at(&mode.id).at(key).at("shift"), diagnostic);
        }
    }
}
