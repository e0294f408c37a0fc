use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Duration, Section};

rule! {
    /// A timeout is how long a master waits until it takes the device for broken. With 0 it does not wait at all, and no device
    /// is fast enough for that. If nothing is known of a time, it is left out: masters have times of their own.
    ///
    /// ## Fires
    /// ```toml
    /// [timeouts]
    /// request = "100 ms"
    /// response = "0 ms"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [timeouts]
    /// request = "100 ms"
    /// response = "2 s"
    /// ```
    pub(super) static RULE = "idle-timeout", Values, Warning, "a master is to wait no time";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let Some(timeouts) = &device.timeouts else { return };
    let times = [
        ("pre-op", timeouts.pre_op),
        ("safe-op-op", timeouts.safe_op_op),
        ("back-to-init", timeouts.back_to_init),
        ("back-to-safe-op", timeouts.back_to_safe_op),
        ("request", timeouts.request),
        ("response", timeouts.response),
    ];
    for (key, _) in times.into_iter().filter(|(_, time)| *time == Some(Duration(0))) {
        let message = format!("`{key}` is 0: a master would not wait at all");
        let diagnostic = Diagnostic::new(&RULE, message, timeouts.origin.value(key), "no time")
            .help("leave it out if no source says it");
        report.push(Section::Timeouts.at(key), diagnostic);
    }
}
