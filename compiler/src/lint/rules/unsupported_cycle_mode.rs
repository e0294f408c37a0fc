use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Section};

rule! {
    /// A limit of cycle times for a mode that the device does not have holds for nothing.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects]
    /// 0x6060 = {}
    /// 0x6061 = {}
    /// 0x6502 = {}
    ///
    /// [modes.8]
    ///
    /// [cycle-times.velocity]
    /// name = "Velocity"
    /// min = "500 us"
    /// modes = [9]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects]
    /// 0x6060 = {}
    /// 0x6061 = {}
    /// 0x6502 = {}
    ///
    /// [modes.8]
    ///
    /// [cycle-times.position]
    /// name = "Position"
    /// min = "500 us"
    /// modes = [8]
    /// ```
    pub(super) static RULE = "unsupported-cycle-mode", ProcessData, Warning,
        "a limit of cycle times is for a mode that the device does not have";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let known = |code: i16| device.modes.iter().any(|mode| mode.code == code || mode.aliases.contains(&code));
    for limit in &device.cycle_times {
        for (place, code) in limit.modes.iter().enumerate().filter(|(_, code)| !known(**code)) {
            let message = format!("`{}` is for mode {code}, which the device does not have", limit.name);
            let modes = match &device.modes[..] {
                [] => "it has no modes of operation".to_owned(),
                modes => lookup::all("mode", modes.iter().map(|mode| mode.code)),
            };
            let at = limit.origin.value(&format!("modes.{place}"));
            let diagnostic = Diagnostic::new(&RULE, message, at, "no such mode").note(modes);
            report.push(Section::CycleTimes.at(&limit.id), diagnostic);
        }
    }
}
