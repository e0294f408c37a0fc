use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Kind, Object};
use crate::source::Layer;

rule! {
    /// What the table of a record or an array says of its value holds for each entry that does not say otherwise. If all
    /// of them do, or there are none, it holds for none, and whoever reads it is misled.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gains"
    /// type = "UINT16"
    ///
    /// [objects.0x2000.entries]
    /// 1 = { name = "Proportional", type = "UINT32" }
    /// 2 = { name = "Integral", type = "UINT32" }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Gains"
    /// type = "UINT16"
    ///
    /// [objects.0x2000.entries]
    /// 1 = { name = "Proportional", type = "UINT32" }
    /// 2 = { name = "Integral" }
    /// ```
    pub(super) static RULE = "overruled-statement", Dictionary, Warning,
        "what an object says of all its entries holds for none";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    // What a variable says, it says of its only entry.
    for object in device.objects.iter().filter(|object| object.kind != Kind::Var || object.entries.len() > 1)
    {
        for key in crate::raw::SHARED.iter().filter(|key| is_overruled(object, key)) {
            let message = format!("the `{key}` of {} holds for none of its entries", object.index);
            let at = object.origin.value(key);
            let first = object.entries.iter().find(|entry| entry.address.subindex > 0);
            let diagnostic = match first {
                Some(entry) => Diagnostic::new(&RULE, message, at, "overruled by each entry")
                    .label(entry.origin.value(key), "as here")
                    .help("take it out, or out of the entries that share it"),
                None => Diagnostic::new(&RULE, message, at, "there is none behind subindex 0")
                    .help("take it out, or describe the entries"),
            };
            report.push(object.index, diagnostic);
        }
    }
}

fn is_overruled(object: &Object, key: &str) -> bool {
    let entries = object.entries.iter().filter(|entry| entry.address.subindex > 0);
    object.origin.layer(key) == Some(Layer::Description)
        && entries.into_iter().all(|entry| !lookup::is_shared(object, entry, key))
}
