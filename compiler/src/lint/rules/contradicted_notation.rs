use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::Literal;
use crate::model::{DataType, Device, Entry, Object};
use crate::source::Value;

rule! {
    /// Manuals print numbers twice, in hexadecimal and in decimal, and a description can say both: `"0x14 (20)"`. If they
    /// differ, one is a misprint, and nobody knows which the device has. The first one is taken.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Number of axes"
    /// type = "UINT8"
    /// default = "0x14 (14)"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Number of axes"
    /// type = "UINT8"
    /// default = "0x14 (20)"
    /// ```
    pub(super) static RULE = "contradicted-notation", Dictionary, Warning,
        "a number in hexadecimal is not the same in decimal";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for object in &device.objects {
        for entry in object.entries.iter().filter(|entry| !matches!(entry.data_type, DataType::Text(_))) {
            for key in ["default", "min", "max"] {
                compare(object, entry, key, report);
            }
        }
    }
}

fn compare(object: &Object, entry: &Entry, key: &str, report: &mut Report) {
    let Some(Value::String(text)) = entry.origin.node(key).map(|node| &node.value) else { return };
    let Some((first, second)) = Literal::twice(text).filter(|(first, second)| first != second) else {
        return;
    };
    let name = lookup::name(object, entry);
    let message = format!("the {} of {name} is {first} in one notation and {second} in the other", word(key));
    let label = format!("0x{first:X} is {first}, 0x{second:X} is {second}");
    let diagnostic = Diagnostic::new(&RULE, message, entry.origin.value(key), label)
        .note(format!("{first}, which stands first, is taken"))
        .help("write the one that holds");
    report.push(name, diagnostic);
}

/// What a key is called.
fn word(key: &str) -> &str {
    match key {
        "min" => "least value",
        "max" => "greatest value",
        _ => "default",
    }
}
