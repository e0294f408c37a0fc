use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// Object 0x6502 announces modes by its 32 bits. A mode with a higher one cannot be announced.
    ///
    /// ## Fires
    /// ```toml
    /// [modes.-1]
    /// id = "jog"
    /// name = "Jog"
    /// supported-bit = 200
    ///
    /// [objects.0x6060]
    /// name = "Modes of operation"
    /// type = "INT8"
    /// access = "rw"
    ///
    /// [objects.0x6061]
    /// name = "Modes of operation display"
    /// type = "INT8"
    ///
    /// [objects.0x6502]
    /// name = "Supported drive modes"
    /// type = "UINT32"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [modes.-1]
    /// id = "jog"
    /// name = "Jog"
    /// supported-bit = 16
    ///
    /// [objects.0x6060]
    /// name = "Modes of operation"
    /// type = "INT8"
    /// access = "rw"
    ///
    /// [objects.0x6061]
    /// name = "Modes of operation display"
    /// type = "INT8"
    ///
    /// [objects.0x6502]
    /// name = "Supported drive modes"
    /// type = "UINT32"
    /// ```
    pub(super) static RULE = "unlistable-mode", StateMachine, Error,
        "the bit that announces a mode is none of those that 0x6502 has";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for mode in &device.modes {
        let Some(bit) = mode.supported_bit.filter(|bit| *bit > 31) else { continue };
        let message = format!("mode {} is announced by bit {bit}, but 0x6502 has 32", mode.code);
        let place = mode.origin.value("supported-bit");
        report.push(Section::Modes.at(mode.code), Diagnostic::new(&RULE, message, place, "0 to 31"));
    }
}
