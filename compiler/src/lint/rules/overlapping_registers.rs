use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
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
    let end = |register: &Register| u32::from(register.address) + u32::from(register.length);
    let mut longest: Option<&Register> = None;
    for register in &device.registers {
        if let Some(other) = longest.filter(|other| u32::from(register.address) < end(other)) {
            let message = format!(
                "`{}` begins at 0x{:04X}, inside of `{}`",
                register.name, register.address, other.name
            );
            let diagnostic = Diagnostic::new(&RULE, message, register.origin.header(), "begins here")
                .label(other.origin.value("length"), "is so long")
                .help("correct the length of the one, or the address of the other");
            report.push(Section::Registers.at(register.address), diagnostic);
        }
        if longest.is_none_or(|other| end(other) < end(register)) {
            longest = Some(register);
        }
    }
}
