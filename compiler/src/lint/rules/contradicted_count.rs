use std::cmp::Ordering;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::Device;

rule! {
    /// Subindex 0 of a record or an array holds the highest subindex that there is. A master that reads an
    /// object entry by entry stops there, or asks for entries that do not exist. Only where a master may write the
    /// number, as that of the errors in 0x1003 to clear them, it counts what is in use, and may be less.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gains"
    ///
    /// [objects.0x2000.entries]
    /// 0 = { default = 3 }
    /// 1 = { name = "Proportional", type = "UINT16" }
    /// 2 = { name = "Integral", type = "UINT16" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gains"
    ///
    /// [objects.0x2000.entries]
    /// 0 = { default = 2 }
    /// 1 = { name = "Proportional", type = "UINT16" }
    /// 2 = { name = "Integral", type = "UINT16" }
    /// ```
    pub(super) static RULE = "contradicted-count", Dictionary, Warning,
        "subindex 0 is not the highest subindex";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let described = device.objects.iter().filter(|object| !object.derived);
    for object in described.filter(|object| object.entries.len() > 1) {
        let Some(count) = object.entry(0) else { continue };
        let Some(says) = count.default.as_ref().and_then(|default| default.integer()) else { continue };
        let highest = object.highest_subindex();
        let help = match says.cmp(&highest.into()) {
            Ordering::Equal => continue,
            Ordering::Greater => format!("describe the others, or write {highest}"),
            Ordering::Less if count.access.writable() => continue,
            Ordering::Less => format!("write {highest}"),
        };
        let message =
            format!("{} says {says} entries, but the last one described is {highest}", count.address);
        let at = count.origin.value("default");
        let last = object.entries.last().map_or(at, |entry| entry.origin.header());
        let diagnostic = Diagnostic::new(&RULE, message, at, format!("{says} by this"));
        report.push(count.address, diagnostic.label(last, "the last one").help(help));
    }
}
