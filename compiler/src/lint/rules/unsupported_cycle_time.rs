use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{CycleTime, Device, Section};

rule! {
    /// A cycle time that none of `[cycle-times]` allows is one that the device does not keep up with, or does not take. Where a
    /// limit names the mode of the configuration or, if it has none, the mode that one of its PDOs is for, only such limits
    /// count.
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
        if device.takes_cycle(configuration, time) {
            continue;
        }
        let message = format!(
            "`{}` sets a cycle time of {time}, which none of the limits for it allows",
            configuration.name
        );
        let limits = device.cycle_times.iter().map(|limit| format!("{}: {}", limit.name, shown(limit)));
        let at = configuration.origin.value("cycle-time");
        let diagnostic = Diagnostic::new(&RULE, message, at, "not allowed")
            .label(any.origin.header(), "the limits")
            .note(lookup::list(limits));
        report.push(Section::Configurations.at(&configuration.id), diagnostic);
    }
}

fn shown(limit: &CycleTime) -> String {
    let min = limit.min.map(|min| format!("at least {min}"));
    let choices = (!limit.choices.is_empty()).then(|| format!("one of {}", lookup::list(&limit.choices)));
    let modes = (!limit.modes.is_empty()).then(|| format!("in mode {}", lookup::list(&limit.modes)));
    lookup::list(min.into_iter().chain(choices).chain(modes))
}
