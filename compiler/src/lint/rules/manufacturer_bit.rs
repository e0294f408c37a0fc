use super::misclassified_error;
use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, ErrorCode, Section};

rule! {
    /// Bit 7 of the error register says that an error is the manufacturer's own. On codes that the profile
    /// defines it tells a master that it cannot know the error, although it could; bit 5 is there for what is
    /// specific to the device profile.
    ///
    /// No standard forbids it, so this is a doubt and not a fault. It is reported once for all codes, at
    /// `errors`, as it comes from one decision of the firmware.
    ///
    /// ## Fires
    /// ```toml
    /// [errors.0x7305]
    /// name = "Encoder fault"
    /// register = 0x81
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [errors.0x7305]
    /// name = "Encoder fault"
    /// register = 0x21
    ///
    /// [errors.0xFF01]
    /// name = "Own fault"
    /// register = 0x81
    /// ```
    pub(super) static RULE = "manufacturer-bit", Values, Warning,
        "errors of the profile are shown as the manufacturer's";
}

const MANUFACTURER: u8 = 0x80;

pub(super) fn check(device: &Device, report: &mut Report) {
    let odd: Vec<&ErrorCode> = device.errors.iter().filter(|error| is_odd(error)).collect();
    let Some((first, others)) = odd.split_first() else { return };
    let names = odd.iter().map(|error| format!("0x{:04X}", error.code)).collect::<Vec<_>>().join(", ");
    let message = match odd.len() {
        1 => format!("{names} is an error of the profile, but sets bit 7, manufacturer-specific"),
        count => format!("{count} errors of the profile set bit 7, manufacturer-specific"),
    };
    let mut diagnostic = Diagnostic::new(&RULE, message, first.origin.value("register"), "bit 7 is 1");
    for other in others.iter().take(2) {
        diagnostic = diagnostic.label(other.origin.value("register"), "and here");
    }
    if odd.len() > 1 {
        diagnostic = diagnostic.note(format!("they are {names}"));
    }
    report.push(Section::Errors, diagnostic.note("bit 5 is for errors that the device profile defines"));
}

/// Whether a code that the profile may define is marked as the manufacturer's; codes whose class has a bit of
/// its own are judged by that.
fn is_odd(error: &ErrorCode) -> bool {
    let marked = error.register.is_some_and(|register| register & MANUFACTURER != 0);
    marked && (0x5000..0xFF00).contains(&error.code) && misclassified_error::class(error).is_none()
}
