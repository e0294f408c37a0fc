use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Object};
use crate::source::Location;

rule! {
    /// The lower half of 0x1000 is the number of the device profile, and so it is in 0x67FF for each axis of a
    /// device that has several. Masters choose their driver by it: 402 is a drive.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [device]
    /// name = "Example"
    /// vendor = "Example"
    /// profile = 401
    ///
    /// [objects.0x1000]
    /// default = 0x00020192
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["ethercat"]
    ///
    /// [device]
    /// name = "Example"
    /// vendor = "Example"
    /// profile = 401
    ///
    /// [objects.0x1000]
    /// default = 0x00000191
    /// ```
    pub(super) static RULE = "contradicted-profile", Dictionary, Warning,
        "two places name different device profiles";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let described = device.profile.map(|profile| Claim {
        profile: i128::from(profile),
        by: "the description".to_owned(),
        at: device.origin.value("profile"),
    });
    let common = lookup::on_axes(device, 0x1000).find_map(claim);
    let expected = described.as_ref().or(common.as_ref());
    for object in lookup::on_axes(device, 0x1000).chain(lookup::on_axes(device, 0x67FF)) {
        if let (Some(found), Some(expected)) = (claim(object), expected)
            && found.profile != expected.profile
        {
            report.push(object.index, contradiction(&found, expected));
        }
    }
}

/// A place that names a device profile.
struct Claim {
    profile: i128,
    by: String,
    at: Location,
}

fn claim(object: &Object) -> Option<Claim> {
    let entry = object.entry(0)?;
    let value = entry.default.as_ref()?.integer()?;
    Some(Claim { profile: value & 0xFFFF, by: object.index.to_string(), at: entry.origin.value("default") })
}

fn contradiction(found: &Claim, expected: &Claim) -> Diagnostic {
    let Claim { profile, by, at } = found;
    let message = format!("{by} says profile {profile}, but {} says {}", expected.by, expected.profile);
    let label = match profile {
        0 => "no profile by its lower half".to_owned(),
        _ => format!("profile {profile} by its lower half"),
    };
    Diagnostic::new(&RULE, message, *at, label).label(expected.at, format!("profile {}", expected.profile))
}
