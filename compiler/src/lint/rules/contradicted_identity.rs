use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Address, Device, Index};

rule! {
    /// 0x1018 says over the mailbox what the EEPROM says at start-up: vendor, product, revision, serial number.
    /// A master that finds another device than it was set up for stops there.
    ///
    /// Firmware may overwrite the entries when it starts; then the defaults of the dictionary are not what a
    /// master reads, and the description does well without them.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [identity]
    /// vendor-id = 0x76D
    /// product-code = 3
    /// revision = 1
    ///
    /// [objects.0x1018.entries]
    /// 2 = { default = 4 }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [identity]
    /// vendor-id = 0x76D
    /// product-code = 3
    /// revision = 1
    ///
    /// [objects.0x1018.entries]
    /// 2 = { default = 3 }
    /// ```
    pub(super) static RULE = "contradicted-identity", Dictionary, Warning,
        "0x1018 is not what the device is known by";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let identity = &device.identity;
    let facts = [
        (1, "vendor-id", identity.vendor_id),
        (2, "product-code", identity.product_code),
        (3, "revision", identity.revision),
        (4, "serial", identity.serial),
    ];
    for (subindex, key, holds) in facts {
        let Some(entry) = device.entry(Address { index: Index(0x1018), subindex }) else { continue };
        let Some(says) = entry.default.as_ref().and_then(|default| default.integer()) else { continue };
        if !identity.origin.has(key) || says == i128::from(holds) {
            continue;
        }
        let message = format!("{} is {says:#X}, but the {} is {holds:#X}", entry.address, words(key));
        let at = entry.origin.value("default");
        let diagnostic = Diagnostic::new(&RULE, message.replace("0X", "0x"), at, "by the dictionary")
            .label(identity.origin.value(key), "by the identity, which the EEPROM has")
            .note("leave the default out if the firmware fills it in when it starts");
        report.push(entry.address, diagnostic);
    }
}

fn words(key: &str) -> &str {
    match key {
        "vendor-id" => "vendor id",
        "product-code" => "product code",
        "serial" => "serial number",
        _ => key,
    }
}
