use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Access, Device};

rule! {
    /// In which states an entry may be written, and when a new value takes effect, is said of what a master can write. Beside an
    /// access without that, one of the two is wrong. So is whether a value is stored beside one that never changes.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Station"
    /// type = "UINT16"
    /// access = "ro"
    /// effective = "restart"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Station"
    /// type = "UINT16"
    /// access = "rw"
    /// effective = "restart"
    /// ```
    pub(super) static RULE = "idle-write-window", Dictionary, Warning,
        "it is said when something may be written that cannot be";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device).filter(|(_, entry)| !entry.access.writable()) {
        let is_constant = entry.access == Access::Const;
        let keys = [
            ("trigger", entry.trigger.is_some(), "what writing it sets off"),
            ("written", entry.written.is_some(), "when it is `written`"),
            ("effective", entry.effective.is_some(), "when it is `effective`"),
            ("stored", entry.stored.is_some() && is_constant, "whether it is `stored`"),
        ];
        for (key, _, what) in keys.into_iter().filter(|(key, says, _)| *says && entry.origin.has(key)) {
            if lookup::is_shared(object, entry, key) {
                continue;
            }
            let message = format!("{} says {what}, but cannot be written", entry.address);
            let diagnostic = Diagnostic::new(&RULE, message, entry.origin.value(key), "of no use").label(
                entry.origin.value("access"),
                if is_constant { "never different" } else { "read only" },
            );
            report.push(lookup::name(object, entry), diagnostic);
        }
    }
}
