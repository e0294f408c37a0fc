use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Kind};

rule! {
    /// The entries of an array have subindices without gaps, from 1 on; masters read them in a row. Records may
    /// leave subindices out.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gains"
    /// kind = "array"
    /// type = "UINT16"
    ///
    /// [objects.0x2000.entries]
    /// 1 = { name = "Proportional" }
    /// 3 = { name = "Integral" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gains"
    /// kind = "array"
    /// type = "UINT16"
    ///
    /// [objects.0x2000.entries]
    /// 1 = { name = "Proportional" }
    /// 2 = { name = "Integral" }
    /// ```
    pub(super) static RULE = "subindex-gap", Dictionary, Warning, "an array leaves a subindex out";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for object in lookup::objects(device).filter(|object| object.kind == Kind::Array) {
        for pair in object.entries.windows(2) {
            let [before, after] = pair else { continue };
            let (from, to) = (before.address.subindex, after.address.subindex);
            if from.checked_add(1) == Some(to) {
                continue;
            }
            let message = format!("{} goes from subindex {from} to {to}", object.index);
            let diagnostic = Diagnostic::new(&RULE, message, after.origin.header(), format!("subindex {to}"))
                .help("describe what lies between, as reserved if it is, or call the object a record");
            report.push(object.index, diagnostic);
        }
    }
}
