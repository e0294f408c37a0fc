use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// The indices below 0x1000 name data types, not objects. A master that reads the dictionary takes what
    /// stands there for a type.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x0800]
    /// name = "Speed"
    /// type = "UINT16"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2800]
    /// name = "Speed"
    /// type = "UINT16"
    /// ```
    pub(super) static RULE = "reserved-index", Dictionary, Warning, "an index is reserved for data types";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for object in lookup::objects(device).filter(|object| object.index.0 < 0x1000) {
        let message = format!("{} lies where data types are, 0x0000 to 0x0FFF", object.index);
        let diagnostic = Diagnostic::new(&RULE, message, object.origin.header(), "not an object's index")
            .note("a manufacturer's objects are at 0x2000 to 0x5FFF");
        report.push(object.index, diagnostic);
    }
}
