use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, lookup};
use crate::model::{Device, Kind};
use crate::source::Value;

rule! {
    /// Where the profile has an array or a record, the values begin at subindex 1 and subindex 0 is their number. A
    /// master that writes the first value of what is a single value here gets an abort, or reads it as a number.
    ///
    /// Arrays and records count as the same: masters address both alike.
    ///
    /// ## Fires
    /// ```toml
    /// profiles = ["cia402"]
    /// without = ["objects.0x60C1.entries"]
    ///
    /// [objects.0x60C1]
    /// kind = "var"
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// profiles = ["cia402"]
    ///
    /// [objects.0x60C1]
    /// kind = "record"
    /// ```
    pub(super) static RULE = "deviating-kind", Dictionary, Warning,
        "an object is a single value where the profile has several, or the other way round";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for object in lookup::objects(device) {
        // what says nothing of its kind is a single value
        let kind = report.profile(&object.origin, "kind");
        let Some(node) = kind.or_else(|| report.profile(&object.origin, "id")) else { continue };
        let single = kind.is_none_or(|kind| matches!(&kind.value, Value::String(kind) if &**kind == "var"));
        if single == (object.kind == Kind::Var) {
            continue;
        }
        let (here, there) = match single {
            true => ("several values", "a single value"),
            false => ("a single value", "several values"),
        };
        let message = format!("{} has {here}, but {there} in the profile", object.index);
        let diagnostic = Diagnostic::new(&RULE, message, object.origin.value("kind"), format!("{here} here"))
            .label(node.at, format!("{there} there"));
        report.push(object.index, diagnostic);
    }
}
