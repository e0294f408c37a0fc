use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// A value of a byte or more that does not begin with a byte is spread over one byte more. Most masters and
    /// many devices cannot handle that; padding in front of it helps.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Ready"
    /// type = "BOOL"
    /// pdo = "tx"
    ///
    /// [objects.0x2001]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000", "0x2001"]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Ready"
    /// type = "BOOL"
    /// pdo = "tx"
    ///
    /// [objects.0x2001]
    /// name = "Speed"
    /// type = "UINT16"
    /// pdo = "tx"
    ///
    /// [tx-pdos.0x1A00]
    /// name = "Values"
    /// entries = ["0x2000", { bits = 7 }, "0x2001"]
    /// ```
    pub(super) static RULE = "misaligned-entry", ProcessData, Warning,
        "a value does not begin with a byte";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (pdo, at, mapped) in lookup::mapped(device) {
        let over = mapped.offset % 8;
        if over == 0 || mapped.bits < 8 || mapped.address.is_none() {
            continue;
        }
        let message = format!("`{}` begins at bit {} of {}", mapped.name, mapped.offset, pdo.index);
        let label = format!("{} bits, {over} behind the last byte", mapped.bits);
        let diagnostic = Diagnostic::new(&RULE, message, mapped.origin.header(), label);
        report
            .push(at, diagnostic.help(format!("put `{{ bits = {} }}` in front of it as padding", 8 - over)));
    }
}
