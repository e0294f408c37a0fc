use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Access, Device};
use crate::source::Value;

rule! {
    /// A profile says whether a master may write a standard object. Where a device refuses, start-up
    /// parameters that masters send are aborted; where it allows more, values can be changed that others
    /// take for given.
    ///
    /// Read only and constant are the same here: what never changes can be read only.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x6041]
    /// access = "rw"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x6041]
    /// access = "const"
    /// ```
    pub(super) static RULE = "deviating-access", Dictionary, Warning,
        "access is not as in the profile";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device) {
        let Some(node) = report.profile(&entry.origin, "access") else { continue };
        let Value::String(profile) = &node.value else { continue };
        let (readable, writable) = match &**profile {
            "ro" | "const" => (true, false),
            "wo" => (false, true),
            _ => (true, true),
        };
        let access = entry.access;
        if readable == access.readable() && writable == access.writable() {
            continue;
        }
        let own = key(access);
        let name = lookup::name(object, entry);
        let message = format!("{name} is {own}, but {profile} in the profile");
        let at = entry.origin.value("access");
        let note = match (readable && !access.readable(), writable && !access.writable()) {
            (true, _) => "masters that read it get an abort",
            (false, true) => "masters that write it get an abort",
            (false, false) => "masters take it for something that only the device changes",
        };
        let diagnostic = Diagnostic::new(&RULE, message, at, format!("not {profile}"))
            .label(node.at, "the profile's access")
            .note(note)
            .suggest("if the device follows the profile", at, format!("\"{profile}\""));
        report.push(name, diagnostic);
    }
}

fn key(access: Access) -> &'static str {
    match access {
        Access::Ro => "ro",
        Access::Wo => "wo",
        Access::Rw => "rw",
        Access::Const => "const",
    }
}
