use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// What belongs to a mode of operation is described, and no such mode is: ways of homing are chosen in the mode for homing,
    /// which is 6 in CiA 402, and nobody can be refused a mode where there is none.
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
    /// [homing-methods.37]
    /// name = "Here"
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
    /// [modes]
    /// 6 = {}
    /// 8 = {}
    ///
    /// [homing-methods.37]
    /// name = "Here"
    /// ```
    pub(super) static RULE = "missing-mode", StateMachine, Warning, "what belongs to a mode is described, and the mode is not";
}

/// The number of the mode for homing in CiA 402.
const HOMING: i16 = 6;

pub(super) fn check(device: &Device, report: &mut Report) {
    let has_homing = device.modes.iter().any(|mode| mode.code == HOMING || mode.homing_bits.is_some());
    if let Some(method) = device.homing_methods.first().filter(|_| !device.modes.is_empty() && !has_homing) {
        let message = "there are homing methods, and no mode in which they run";
        let diagnostic = Diagnostic::new(&RULE, message, method.origin.header(), "the first of them")
            .help("describe the mode in `[modes.6]`, or with its `homing-bits`, or take the methods out");
        report.push(Section::HomingMethods.at(method.number), diagnostic);
    }
    let Some(control) = device.device_control.as_ref().filter(|_| device.modes.is_empty()) else { return };
    for key in ["wrong-mode", "modes-selectable-in"].into_iter().filter(|key| control.origin.has(key)) {
        let message = format!("`{key}` is about modes of operation, and there are none");
        let diagnostic = Diagnostic::new(&RULE, message, control.origin.value(key), "says nothing")
            .help("describe the modes in `[modes]`, or take it out");
        report.push(Section::DeviceControl.at(key), diagnostic);
    }
}
