use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// An object without function can be read and written, but nothing happens. Mapped into a PDO it takes
    /// bytes of every cycle, and a reader will think that they matter.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Mode"
    /// type = "INT8"
    /// access = "rw"
    /// pdo = "rx"
    /// functional = false
    ///
    /// [rx-pdos.0x1600]
    /// name = "Setpoints"
    /// entries = ["0x2000"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Mode"
    /// type = "INT8"
    /// access = "rw"
    /// pdo = "rx"
    ///
    /// [rx-pdos.0x1600]
    /// name = "Setpoints"
    /// entries = ["0x2000"]
    /// ```
    pub(super) static RULE = "idle-mapped-entry", ProcessData, Warning,
        "a PDO carries an object that has no function";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (pdo, at, mapped) in lookup::mapped(device) {
        let Some((object, entry)) = lookup::target(device, mapped) else { continue };
        if object.functional && entry.functional {
            continue;
        }
        let name = lookup::name(object, entry);
        let message = format!("{} carries {name}, which is without function", pdo.index);
        let bits = mapped.bits;
        let diagnostic =
            Diagnostic::new(&RULE, message, mapped.origin.header(), format!("{bits} bits in every cycle"))
                .label(entry.origin.value("functional"), "says that it does nothing")
                .help("take it out of the PDO, unless the device has it there by default");
        report.push(at, diagnostic);
    }
}
