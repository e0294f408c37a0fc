use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// A PDO gives each object its whole width. With another one, this object and all behind it are read at the
    /// wrong place.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = [{ entry = "0x2000", bits = 32 }]
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
    /// entries = [{ entry = "0x2000", bits = 16 }]
    /// ```
    pub(super) static RULE = "contradicted-width", ProcessData, Warning,
        "an object is mapped with a width that is not its own";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (pdo, at, mapped) in lookup::mapped(device) {
        let Some((object, entry)) = lookup::target(device, mapped) else { continue };
        let (says, holds) = (mapped.bits, entry.data_type.bits());
        if says == holds {
            continue;
        }
        let name = lookup::name(object, entry);
        let message = format!("{} maps {name} with {says} bits, but it has {holds}", pdo.index);
        let diagnostic = Diagnostic::new(&RULE, message, mapped.origin.header(), format!("{says} bits"))
            .label(entry.origin.value("type"), format!("{} has {holds}", entry.data_type));
        report.push(at, diagnostic);
    }
}
