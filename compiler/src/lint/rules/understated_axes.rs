use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;

rule! {
    /// The upper half of 0x1000 says which kind of drive a device is. A device with several axes has 0xFFFF
    /// there by CiA 301, and tells the kind of each axis in 0x67FF, 0x6FFF and so on; with the kind of a
    /// single drive, masters look for one axis only.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [axes]
    /// names = ["X", "Y"]
    ///
    /// [objects.0x1000]
    /// default = 0x00020192
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [axes]
    /// names = ["X", "Y"]
    ///
    /// [objects.0x1000]
    /// default = 0xFFFF0192
    /// ```
    pub(super) static RULE = "understated-axes", Dictionary, Warning,
        "0x1000 describes one drive where there are several";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let axes = device.axes.len();
    let entry = lookup::on_axes(device, 0x1000).find_map(|object| object.entry(0));
    let Some(entry) = entry.filter(|_| axes > 1) else { return };
    let Some(value) = entry.default.as_ref().and_then(|default| default.integer()) else { return };
    let (kind, profile) = (value >> 16, value & 0xFFFF);
    if kind == 0xFFFF {
        return;
    }
    let message = format!("0x1000 describes a single drive of kind 0x{kind:04X}, but there are {axes} axes");
    let at = entry.origin.value("default");
    let diagnostic = Diagnostic::new(&RULE, message, at, "the upper half is not 0xFFFF")
        .note(
            "CiA 301 has 0xFFFF there for a device with several; each axis has its own in 0x67FF + n × 0x800",
        )
        .suggest("say that there are several", at, format!("0xFFFF{profile:04X}"));
    report.push(entry.address.index, diagnostic);
}
