use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, sibling};
use crate::model::{Device, Identity, Section};

rule! {
    /// A master finds the description of a device by vendor id, product code and revision. If members of a family
    /// share all three but not their process data, it takes one for the other, and the process image is
    /// wrong. The ETG asks for a product code or a revision of its own for each.
    ///
    /// ## Fires
    /// ```toml
    /// [family]
    /// name = "Twins"
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    ///
    /// [members.one]
    /// [members.two]
    /// without = ["tx-pdos.0x1A00"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [family]
    /// name = "Twins"
    ///
    /// [objects.0x2000]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000"]
    ///
    /// [members.one]
    /// [members.two]
    /// without = ["tx-pdos.0x1A00"]
    /// identity = { revision = 2 }
    /// ```
    pub(crate) static RULE = "indistinct-members", Output, Warning,
        "members of a family differ in process data, but not in identity";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let (mine, image) = (numbers(&device.identity), sibling::image(device));
    let alike = || report.earlier().iter().filter(|other| numbers(&other.identity) == mine);
    let Some(first) = alike().next().filter(|first| first.image != image) else { return };
    // Once is enough: that more of them differ follows.
    if alike().any(|other| other.image != first.image) {
        return;
    }
    let (_, product, revision) = mine;
    let message = format!(
        "`{}` and `{}` share product code 0x{product:08X} and revision {revision}, but not their process data",
        first.id, device.id
    );
    let place = device.identity.origin.value("product-code");
    let diagnostic = Diagnostic::new(&RULE, message, place, "the same for both")
        .note("a master takes the one for the other")
        .help("give one of them a product code or a revision of its own");
    report.push(Section::Identity, diagnostic);
}

fn numbers(identity: &Identity) -> (u32, u32, u32) {
    (identity.vendor_id, identity.product_code, identity.revision)
}
