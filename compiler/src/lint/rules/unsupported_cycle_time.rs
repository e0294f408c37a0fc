use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{CycleTime, Device, Duration, Section};

rule! {
    /// A cycle time that none of `[cycle-times]` allows is one that the device does not keep up with, or does not take.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x60C2]
    ///
    /// [cycle-times.all]
    /// name = "All modes"
    /// min = "1 ms"
    ///
    /// [configurations.fast]
    /// name = "Fast"
    /// cycle-time = "500 us"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x60C2]
    ///
    /// [cycle-times.all]
    /// name = "All modes"
    /// min = "1 ms"
    ///
    /// [configurations.fast]
    /// name = "Fast"
    /// cycle-time = "2 ms"
    /// ```
    pub(super) static RULE = "unsupported-cycle-time", ProcessData, Warning,
        "a configuration sets a cycle time that the device does not have";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let Some(any) = device.cycle_times.first() else { return };
    for configuration in &device.configurations {
        let Some(time) = configuration.cycle_time else { continue };
        if device.cycle_times.iter().any(|limit| allows(limit, time)) {
            continue;
        }
        let message = format!("`{}` sets a cycle time of {time}, which no limit allows", configuration.name);
        let limits = device.cycle_times.iter().map(|limit| format!("{}: {}", limit.name, shown(limit)));
        let at = configuration.origin.value("cycle-time");
        let diagnostic = Diagnostic::new(&RULE, message, at, "not allowed")
            .label(any.origin.header(), "the limits")
            .note(lookup::list(limits));
        report.push(Section::Configurations.at(&configuration.id), diagnostic);
    }
}

fn allows(limit: &CycleTime, time: Duration) -> bool {
    let is_chosen = limit.choices.is_empty() || limit.choices.contains(&time);
    is_chosen && limit.min.is_none_or(|min| time >= min)
}

fn shown(limit: &CycleTime) -> String {
    let min = limit.min.map(|min| format!("at least {min}"));
    let choices = (!limit.choices.is_empty()).then(|| format!("one of {}", lookup::list(&limit.choices)));
    lookup::list(min.into_iter().chain(choices))
}
