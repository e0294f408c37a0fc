use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Mappable};
use crate::source::Value;

rule! {
    /// A PDO may carry only what the dictionary marks as mappable; a master that checks the mapping refuses
    /// anything else.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "none"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    /// ```
    pub(super) static RULE = "unmappable-entry", ProcessData, Warning,
        "a PDO maps what is not mappable";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (pdo, at, mapped) in lookup::mapped(device) {
        let Some((object, entry)) = lookup::target(device, mapped) else { continue };
        if entry.pdo != Mappable::None {
            continue;
        }
        let name = lookup::name(object, entry);
        let message = format!("{} maps {name}, which cannot be mapped", pdo.index);
        let diagnostic = Diagnostic::new(&RULE, message, mapped.origin.header(), "mapped here");
        let is_offered = entry
            .origin
            .node("pdo")
            .is_some_and(|it| !matches!(&it.value, Value::String(t) if &**t == "none"));
        let diagnostic = match is_offered {
            true => diagnostic.note(
                "the `pdo` that it has holds where mappings can be changed and it is written in Operational",
            ),
            false => diagnostic.label(entry.origin.value("pdo"), "not mappable"),
        };
        report.push(at, diagnostic.help("write `pdo = \"rx\"` or `pdo = \"tx\"` if the device maps it"));
    }
}
