use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::Device;

rule! {
    /// A list that names one thing twice, be it in two spellings, has an item that was meant to be another one. Outputs say
    /// it twice: an ESI has a module twice in a slot, of which a tool refuses one.
    ///
    /// ## Fires
    /// ```toml
    /// [slots.place]
    /// name = "Place"
    /// max = 1
    /// modules = [0x100, 256]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [slots.place]
    /// name = "Place"
    /// max = 1
    /// modules = [0x100, 0x256]
    /// ```
    pub(super) static RULE = "repeated-item", Facts, Warning, "a list names one thing twice";
}

/// The lists in which one thing twice means something, or which another rule judges.
const OTHERS: &[(&str, &str)] = &[
    ("steps", "one can be done again"),
    ("data", "it is bytes"),
    ("outputs", "`repeated-assignment` judges it"),
    ("inputs", "`repeated-assignment` judges it"),
    ("pdos", "`repeated-assignment` judges it"),
    ("aliases", "`repeated-alias` judges it"),
];

pub(super) fn check(device: &Device, report: &mut Report) {
    for slip in &*report.slips(device) {
        let Some(item) = &slip.twice else { continue };
        if OTHERS.iter().any(|(name, _)| *name == slip.key) {
            continue;
        }
        let [second, first] = slip.at;
        let message = format!("`{}` names `{item}` twice", slip.key);
        let diagnostic = Diagnostic::new(&RULE, message, second, "again here")
            .label(first, "first here")
            .help("leave one of them out, or name what was meant");
        report.push(slip.place.clone(), diagnostic);
    }
}
