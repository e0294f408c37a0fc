use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Object};

rule! {
    /// CiA 402 gives each axis 0x800 indices from 0x6000 on: the first has 0x6000 to 0x67FF, the second 0x6800 to
    /// 0x6FFF. An object there belongs to that axis. If the device has no such axis, or the object
    /// stands there for one axis only, its index is a misprint or the axes are described wrongly.
    ///
    /// ## Fires
    /// ```toml
    /// [device]
    /// name = "Drive"
    /// vendor = "Example"
    /// profile = 402
    ///
    /// [objects]
    /// 0x6040 = { name = "Controlword", type = "UINT16", access = "rw" }
    /// 0x6041 = { name = "Statusword", type = "UINT16" }
    /// 0x6864 = { name = "Position", type = "INT32" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [device]
    /// name = "Drive"
    /// vendor = "Example"
    /// profile = 402
    ///
    /// [objects]
    /// 0x6040 = { name = "Controlword", type = "UINT16", access = "rw" }
    /// 0x6041 = { name = "Statusword", type = "UINT16" }
    /// 0x6064 = { name = "Position", type = "INT32" }
    /// ```
    pub(super) static RULE = "stray-profile-object", Dictionary, Warning,
        "an object of the profile lies in the range of no axis, or of one only";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    if device.profile != Some(402) {
        return;
    }
    for object in lookup::objects(device).filter(|object| object.axis.is_none()) {
        let Some((axis, why, help)) = stray(device, object) else { continue };
        let message = format!("{} lies in the range of axis {axis}, but {why}", object.index);
        let label = format!("of axis {axis} by its index");
        let diagnostic = Diagnostic::new(&RULE, message, object.origin.header(), label)
            .note("CiA 402 has axis n at 0x6000 + n × 0x800 to 0x67FF + n × 0x800, the first with n = 0")
            .help(help);
        report.push(object.index, diagnostic);
    }
}

/// The axis in whose range an object lies, counted from 1, why it should not, and what to do; none if all is well.
fn stray(device: &Device, object: &Object) -> Option<(usize, String, &'static str)> {
    let window = usize::from(object.index.0.checked_sub(0x6000)? / 0x800);
    let add = "name the axis in `[axes]`, or give the object the index that it has on its own axis";
    let (why, help) = match device.axes.len() {
        _ if object.index.0 > 0x9FFF => return None,
        1 if window == 0 => return None,
        1 => ("there is only one".to_owned(), add),
        axes if window >= axes => (format!("there are only {axes}"), add),
        _ => ("`[axes] shifts` does not repeat it".to_owned(), "repeat its range there if every axis has it"),
    };
    Some((window + 1, why, help))
}
