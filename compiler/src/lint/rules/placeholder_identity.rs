use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// Masters tell devices apart by these numbers. One that looks as if nobody had filled it in, a 0 or
    /// digits in a row, makes devices look the same that are not, or finds the wrong file for one.
    ///
    /// A serial number of 0 is fine: it says that the device has none. So is a number that is marked as assumed.
    ///
    /// ## Fires
    /// ```toml
    /// [identity]
    /// vendor-id = 0x76D
    /// product-code = 3
    /// revision = 1
    /// serial = 0x12345678
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [identity]
    /// vendor-id = 0x76D
    /// product-code = 3
    /// revision = 1
    /// serial = 0x01A4003B
    /// ```
    pub(super) static RULE = "placeholder-identity", Facts, Warning,
        "a number of the identity looks like a placeholder";
}

/// Serial numbers that people type when they have none.
const DUMMIES: [u32; 6] = [0x1234_5678, 0x1234_ABCD, 0x1122_3344, 0xDEAD_BEEF, 0xCAFE_BABE, 0xFFFF_FFFF];

pub(super) fn check(device: &Device, report: &mut Report) {
    let identity = &device.identity;
    let zeros = [
        ("vendor-id", "vendor id", identity.vendor_id),
        ("product-code", "product code", identity.product_code),
        ("revision", "revision", identity.revision),
    ];
    let assumed = |key: &str| device.assumptions.iter().any(|it| it.at == Section::Identity.at(key));
    let mut push = |key: &str, message: String, note: &str| {
        if assumed(key) {
            return;
        }
        let diagnostic = Diagnostic::new(&RULE, message, identity.origin.value(key), "a placeholder?");
        let help = "write the real one, or say under `assumed` why there is none";
        report.push(Section::Identity.at(key), diagnostic.note(note).help(help));
    };
    for (key, name, value) in zeros {
        if value == 0 {
            push(key, format!("{name} 0 looks like a placeholder"), "0 is also what an empty EEPROM says");
        }
    }
    if DUMMIES.contains(&identity.serial) {
        let message = format!("serial number 0x{:08X} looks like a placeholder", identity.serial);
        push("serial", message, "every device has its own serial number, or 0 if it has none");
    }
}
