use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// A revision takes the place of older ones: tools hide those and offer it. One that hides itself or a newer one
    /// cannot be found any more.
    ///
    /// ## Fires
    /// ```toml
    /// [identity]
    /// vendor-id = 0x76D
    /// product-code = 3
    /// revision = 2
    /// replaces = [2]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [identity]
    /// vendor-id = 0x76D
    /// product-code = 3
    /// revision = 2
    /// replaces = [1]
    /// ```
    pub(crate) static RULE = "replaced-revision", Output, Warning,
        "a revision takes the place of itself or of a newer one";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let identity = &device.identity;
    for (i, replaced) in identity.replaces.iter().enumerate() {
        if *replaced >= identity.revision {
            let message = format!("revision {} cannot take the place of {replaced}", identity.revision);
            let at = identity.origin.value(&format!("replaces.{i}"));
            let diagnostic = Diagnostic::new(&RULE, message, at, "not older")
                .label(identity.origin.value("revision"), "this revision");
            report.push(Section::Identity.at("replaces"), diagnostic);
        }
    }
}
