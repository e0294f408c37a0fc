use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, ErrorCode};

rule! {
    /// The error register 0x1001 shows the class of an error by a bit, and the first digits of the error code
    /// show it, too: 2xxx is current, 3xxx voltage, 4xxx temperature, 81xx and 82xx communication, FFxx the
    /// manufacturer's. Bit 0 comes with every error. A master that looks at the register alone takes an error
    /// for something else if the two disagree.
    ///
    /// Codes of the other classes have no bit of their own and are not judged.
    ///
    /// ## Fires
    /// ```toml
    /// [errors.0x3130]
    /// name = "Phase failure"
    /// register = 0x81
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [errors.0x3130]
    /// name = "Phase failure"
    /// register = 0x05
    /// ```
    pub(super) static RULE = "misclassified-error", Values, Warning,
        "the error register does not show the class of the code";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for error in device.errors.iter().filter(|error| error.code != 0) {
        if let Some(register) = error.register
            && let Some((expected, what)) = missing(error, register)
        {
            report.push(error.place(), judge(error, register, expected, what));
        }
    }
}

/// The bit that the register should have and does not, with its name.
fn missing(error: &ErrorCode, register: u8) -> Option<(u8, &'static str)> {
    let generic = (0x01, "generic error");
    let class = class(error).into_iter().chain([generic]);
    class.into_iter().find(|(bit, _)| register & bit == 0)
}

/// The bit of the register that the class of a code has, with its name.
pub(super) fn class(error: &ErrorCode) -> Option<(u8, &'static str)> {
    let of = |code: u16| match code {
        0x2000..=0x2FFF => Some((0x02, "current")),
        0x3000..=0x3FFF => Some((0x04, "voltage")),
        0x4000..=0x4FFF => Some((0x08, "temperature")),
        0x8100..=0x82FF => Some((0x10, "communication")),
        0xFF00..=0xFFFF => Some((0x80, "manufacturer-specific")),
        _ => None,
    };
    of(error.code).filter(|class| of(error.last) == Some(*class))
}

fn judge(error: &ErrorCode, register: u8, bit: u8, what: &str) -> Diagnostic {
    let code = format!("0x{:04X}", error.code);
    let number = bit.trailing_zeros();
    let message = format!("{code} sets 0x{register:02X} in the error register, without bit {number}, {what}");
    let at = error.origin.value("register");
    let diagnostic = Diagnostic::new(&RULE, message, at, format!("bit {number} is 0")).label(
        error.origin.header(),
        if bit == 1 { "an error".to_owned() } else { format!("{what} by its code") },
    );
    let usual = class(error).map_or(0, |(bit, _)| bit) | 0x01;
    diagnostic.help(format!("0x{usual:02X} would show what the code says"))
}
