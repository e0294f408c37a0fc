use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Object};

rule! {
    /// Two objects of one name cannot be told apart in a list, and generated code has to number them. Objects of
    /// different axes may share a name: the axis tells them apart.
    ///
    /// ## Fires
    /// ```toml
    /// [objects.0x2000]
    /// name = "Direction"
    /// type = "UINT8"
    ///
    /// [objects.0x2001]
    /// name = "direction"
    /// type = "UINT8"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [objects.0x2000]
    /// name = "Direction"
    /// type = "UINT8"
    ///
    /// [objects.0x2001]
    /// name = "Direction of travel"
    /// type = "UINT8"
    /// ```
    pub(super) static RULE = "ambiguous-name", Dictionary, Warning, "two objects have one name";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut first: BTreeMap<(Option<u8>, String), &Object> = BTreeMap::new();
    for object in lookup::objects(device) {
        let key = (object.axis, object.name.to_lowercase());
        let Some(other) = first.get(&key) else {
            first.insert(key, object);
            continue;
        };
        let message = format!("{} and {} are both called `{}`", other.index, object.index, object.name);
        let diagnostic = Diagnostic::new(&RULE, message, object.origin.value("name"), "the same name")
            .label(other.origin.value("name"), format!("{} has it, too", other.index))
            .help("add a word to one of them that tells them apart");
        report.push(object.index, diagnostic);
    }
}
