use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// An array has values of one type, and the ESI and programs give it one. With another type in it, it is a record.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Filter"
    /// kind = "array"
    /// entries.1 = { name = "Time", type = "UINT16" }
    /// entries.2 = { name = "Kind", type = "UINT8" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Filter"
    /// kind = "record"
    /// entries.1 = { name = "Time", type = "UINT16" }
    /// entries.2 = { name = "Kind", type = "UINT8" }
    /// ```
    pub(super) static RULE = "contradicted-kind", Dictionary, Warning, "an array has values of several types";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for object in lookup::objects(device) {
        let Some((first, other)) = lookup::of_two_types(object) else { continue };
        let message = format!(
            "{} is an array, but {} is {} and {} is {}",
            object.index, first.address, first.data_type, other.address, other.data_type
        );
        let diagnostic = Diagnostic::new(&RULE, message, other.origin.value("type"), "another type")
            .label(first.origin.value("type"), "the type of the first")
            .help("write `kind = \"record\"`, or correct the type");
        report.push(object.index, diagnostic);
    }
}
