use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Mappable};
use crate::source::Value;

rule! {
    /// Some standard objects are not meant for process data: identity, lists, settings that take effect only
    /// at start-up. A device may still map them, but masters that know the profile will not offer it.
    ///
    /// Fewer ways to map than the profile has are no fault.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [objects.0x1008]
    /// type = "STRING(8)"
    /// pdo = "tx"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [objects.0x1001]
    /// pdo = "none"
    /// ```
    pub(super) static RULE = "deviating-mapping", Dictionary, Warning,
        "what the profile keeps out of process data can be mapped";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let Some(node) = report.profile(&entry.origin, "pdo") else { continue };
        let forbidden = matches!(&node.value, Value::String(pdo) if &**pdo == "none");
        if !forbidden || entry.pdo == Mappable::None {
            continue;
        }
        let name = lookup::name(object, entry);
        let message = format!("{name} can be mapped, but not in the profile");
        let at = entry.origin.value("pdo");
        let diagnostic = Diagnostic::new(&RULE, message, at, "mappable here")
            .label(node.at, "not mappable there")
            .suggest("if the device follows the profile", at, "\"none\"");
        report.push(name, diagnostic);
    }
}
