use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{DataType, Device, Place};
use crate::source::Value;

rule! {
    /// A standard object has the type that its profile gives it; masters and libraries are written for that.
    /// Another width shifts all that follows in a PDO, another sign turns large values into negative ones.
    ///
    /// Bit strings and unsigned numbers of the same width count as the same, and so do texts of any length.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x60FD]
    /// type = "INT32"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x60FD]
    /// type = "DWORD"
    /// ```
    pub(super) static RULE = "deviating-type", Dictionary, Warning,
        "a type is not the one of the profile";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let Some(node) = report.profile(&entry.origin, "type") else { continue };
        let Value::String(text) = &node.value else { continue };
        let Ok(profile) = text.parse::<DataType>() else { continue };
        if alike(profile, entry.data_type) {
            continue;
        }
        let shared = lookup::is_shared(object, entry, "type");
        let name = if shared { Place::from(object.index) } else { lookup::name(object, entry) };
        let message = format!("{name} is {}, but {profile} in the profile", entry.data_type);
        let at = entry.origin.value("type");
        let diagnostic = Diagnostic::new(&RULE, message, at, format!("not {profile}"))
            .label(node.at, "the profile's type")
            .note(consequence(profile, entry.data_type))
            .suggest("if the device follows the profile", at, format!("\"{profile}\""));
        report.push(name, diagnostic);
    }
}

/// Whether two types are the same on the wire and in what their values mean.
fn alike(a: DataType, b: DataType) -> bool {
    let plain = |data_type| match data_type {
        DataType::Bitstring(bits) => DataType::Uint(bits),
        DataType::Text(_) => DataType::Text(0),
        other => other,
    };
    plain(a) == plain(b)
}

fn consequence(profile: DataType, device: DataType) -> String {
    if profile.bits() == device.bits() {
        format!("both have {} bits; only some values differ in meaning", profile.bits())
    } else {
        format!("a master made for the profile transfers {} bits, not {}", profile.bits(), device.bits())
    }
}
