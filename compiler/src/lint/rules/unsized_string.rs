use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Device;
use crate::source::Value;

rule! {
    /// A text in the dictionary has a length: the dictionary, an ESI and a struct all reserve its bytes. A
    /// `STRING` without one is as long as its default; without a default nobody knows.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Label"
    /// type = "STRING"
    /// access = "rw"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Label"
    /// type = "STRING(16)"
    /// access = "rw"
    /// ```
    pub(super) static RULE = "unsized-string", Dictionary, Warning, "a text has no length";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (object, entry) in lookup::entries(device).filter(|(_, entry)| entry.default.is_none()) {
        let written = [&entry.origin, &object.origin].into_iter().find_map(|origin| origin.node("type"));
        let Some(node) = written.filter(|node| matches!(&node.value, Value::String(t) if &**t == "STRING"))
        else {
            continue;
        };
        let name = lookup::name(object, entry);
        let message = format!("{name} is a text of unknown length; 1 byte is reserved for it");
        let diagnostic = Diagnostic::new(&RULE, message, node.at, "no length")
            .label(object.origin.header(), "of this object")
            .help("write the length, as in `STRING(16)`, or a default of that length");
        report.push(name, diagnostic);
    }
}
