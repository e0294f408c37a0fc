use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::lint::overlap::overlapping;
use crate::model::{Device, Register, Section};

rule! {
    /// A byte of a slave controller belongs to one register. Where two share one, the address or the length of one of them is
    /// wrong.
    ///
    /// ## Fires
    /// ```toml
    /// [registers]
    /// 0x0120 = { name = "AL control", length = 4, ecat = "rw", drive = "r" }
    /// 0x0122 = { name = "Reserved", length = 2, ecat = "r", drive = "r" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [registers]
    /// 0x0120 = { name = "AL control", length = 2, ecat = "rw", drive = "r" }
    /// 0x0122 = { name = "Reserved", length = 2, ecat = "r", drive = "r" }
    /// ```
    pub(super) static RULE = "overlapping-registers", Values, Warning, "two registers share a byte";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (other, register) in overlapping(&device.registers, bytes) {
        let message =
            format!("`{}` begins at 0x{:04X}, inside of `{}`", register.name, register.address, other.name);
        let diagnostic = Diagnostic::new(&RULE, message, register.origin.header(), "begins here")
            .label(other.origin.value("length"), "is so long")
            .help("correct the length of the one, or the address of the other");
        report.push(Section::Registers.at(register.address), diagnostic);
    }
}

/// The first byte of a register and the last.
fn bytes(register: &Register) -> (i64, i64) {
    let first = i64::from(register.address);
    (first, first + i64::from(register.length) - 1)
}
