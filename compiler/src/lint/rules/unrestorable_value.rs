use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// A tool reads backups and settings, and writes them back (ETG.1000.6). What cannot be read or written is neither.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Hours"
    /// type = "UINT32"
    /// access = "ro"
    /// backup = true
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gain"
    /// type = "UINT32"
    /// access = "rw"
    /// backup = true
    /// ```
    pub(super) static RULE = "unrestorable-value", Dictionary, Warning,
        "a backup holds what cannot be read or written";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let keys = [("backup", entry.backup), ("setting", entry.setting)];
        let said = keys.into_iter().find(|(key, says)| *says && !lookup::is_shared(object, entry, key));
        let (lacks, does, only) = match (entry.access.readable(), entry.access.writable()) {
            (_, false) => ("written", "written back by tools", "read only"),
            (false, _) => ("read", "read by tools", "write only"),
            (true, true) => continue,
        };
        if let Some((key, _)) = said {
            let message = format!("{} is a `{key}`, but it cannot be {lacks}", entry.address);
            let diagnostic = Diagnostic::new(&RULE, message, entry.origin.value(key), does)
                .label(entry.origin.value("access"), only);
            report.push(lookup::name(object, entry), diagnostic);
        }
    }
}
