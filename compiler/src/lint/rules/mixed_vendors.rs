use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// A family has one ESI file, and an ESI file has one vendor. A member with another vendor id would be
    /// listed under the wrong one, and no master would find it by what the device says.
    ///
    /// ## Fires
    /// ```toml
    /// [family]
    /// name = "Twins"
    ///
    /// [identity]
    /// product-code = 3
    /// revision = 1
    ///
    /// [members.one]
    /// identity = { vendor-id = 1 }
    ///
    /// [members.two]
    /// identity = { vendor-id = 2 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [family]
    /// name = "Twins"
    ///
    /// [identity]
    /// vendor-id = 1
    /// product-code = 3
    /// revision = 1
    ///
    /// [members.one]
    /// [members.two]
    /// ```
    pub(crate) static RULE = "mixed-vendors", Output, Error, "the members of a family have different vendor ids";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let Some(first) = report.earlier().first() else { return };
    let (mine, other) = (device.identity.vendor_id, first.identity.vendor_id);
    if mine == other {
        return;
    }
    let message = format!(
        "`{}` has vendor id 0x{mine:X}, but `{}` of the same family 0x{other:X}",
        device.id, first.id
    );
    let diagnostic =
        Diagnostic::new(&RULE, message, device.identity.origin.value("vendor-id"), "another vendor")
            .label(first.identity.origin.value("vendor-id"), format!("that of `{}`", first.id))
            .help("describe devices of another vendor in a folder of their own");
    report.push(Section::Identity.at("vendor-id"), diagnostic);
}
