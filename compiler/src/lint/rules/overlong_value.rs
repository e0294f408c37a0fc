use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// SOES counts the bits of a value with 16 bits, so one of more than 8191 bytes is not in its object list.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Log"
    /// type = "STRING(8192)"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Log"
    /// type = "STRING(8191)"
    /// ```
    pub(crate) static RULE = "overlong-value", Output, Warning, "a value is longer than SOES can count";
}

/// The most bits that a value can have.
pub(crate) const MOST_BITS: u32 = u16::MAX as u32;

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let bytes = entry.data_type.bytes();
        if entry.data_type.bits() <= MOST_BITS {
            continue;
        }
        let name = lookup::name(object, entry);
        let message = format!("{name} has {bytes} bytes; SOES counts up to {}", MOST_BITS / 8);
        let origin = if entry.origin.has("type") { &entry.origin } else { &object.origin };
        report.push(name, Diagnostic::new(&RULE, message, origin.value("type"), "is left out for SOES"));
    }
}
