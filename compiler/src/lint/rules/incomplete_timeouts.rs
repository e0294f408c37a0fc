use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Duration, Section};

rule! {
    /// An ESI has the four timeouts of the state machine together or not at all, and so the two of the mailbox; each in
    /// whole milliseconds. What is left out would keep the others out of the file.
    ///
    /// ## Fires
    /// ```toml
    /// [timeouts]
    /// pre-op = "3 s"
    /// safe-op-op = "10 s"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [timeouts]
    /// pre-op = "3 s"
    /// safe-op-op = "10 s"
    /// back-to-init = "5 s"
    /// back-to-safe-op = "200 ms"
    /// ```
    pub(crate) static RULE = "incomplete-timeouts", Output, Warning,
        "an ESI cannot tell a timeout";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let Some(timeouts) = &device.timeouts else { return };
    let states = [
        ("pre-op", timeouts.pre_op),
        ("safe-op-op", timeouts.safe_op_op),
        ("back-to-init", timeouts.back_to_init),
        ("back-to-safe-op", timeouts.back_to_safe_op),
    ];
    let mailbox = [("request", timeouts.request), ("response", timeouts.response)];
    for together in [&states[..], &mailbox[..]] {
        let missing = together.iter().filter(|(_, time)| time.is_none()).map(|(key, _)| format!("`{key}`"));
        let missing: Vec<String> = missing.collect();
        if !missing.is_empty() && missing.len() < together.len() {
            let message =
                format!("these timeouts are told together, and {} is missing", lookup::list(&missing));
            let at = timeouts.origin.header();
            let diagnostic = Diagnostic::new(&RULE, message, at, "in the ESI there is none of them");
            report.push(Section::Timeouts.at(missing.join(", ").trim_matches('`')), diagnostic);
        }
        for (key, time) in together.iter().filter_map(|(key, time)| Some((*key, (*time)?))) {
            if let Some(fault) = unfit(time) {
                let at = timeouts.origin.value(key);
                let diagnostic = Diagnostic::new(&RULE, format!("`{key}` {fault}"), at, "cannot be told");
                report.push(Section::Timeouts.at(key), diagnostic);
            }
        }
    }
}

/// Why an ESI cannot hold a time, if it cannot.
fn unfit(Duration(time): Duration) -> Option<&'static str> {
    match time {
        _ if !time.is_multiple_of(1_000_000) => Some("is no whole number of milliseconds"),
        _ if time / 1_000_000 > i32::MAX.unsigned_abs().into() => {
            Some("is longer than 31 bits of milliseconds")
        }
        _ => None,
    }
}
