use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, texts};
use crate::model::Device;

rule! {
    /// A text in which nothing is says nothing, and outputs print it: an empty row, or a sentence that ends where it should go
    /// on.
    ///
    /// ## Fires
    /// ```toml
    /// [limits.cable]
    /// name = "Length of a cable"
    /// value = " "
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [limits.cable]
    /// name = "Length of a cable"
    /// value = "100 m"
    /// ```
    pub(super) static RULE = "blank-text", Facts, Warning, "a text says nothing";
}

/// The texts that another rule judges, or that mean something.
const OTHERS: &[(&str, &str)] =
    &[("why", "`empty-reason` judges it"), ("physics", "a space is a port that is not there")];

pub(super) fn check(device: &Device, report: &mut Report) {
    let slips = report.slips(device);
    let mut blank = slips.iter().filter(|slip| slip.twice.is_none()).peekable();
    if blank.peek().is_none() {
        return;
    }
    // `empty-name` judges these
    let names = texts::named(device).into_iter().map(|named| named.origin.value(&named.path));
    let head = ["name", "vendor", "group", "type-name"].map(|key| device.origin.value(key));
    let names: BTreeSet<_> = names.chain(head).collect();
    for slip in blank {
        let [at, _] = slip.at;
        if !names.contains(&at) && !OTHERS.iter().any(|(name, _)| *name == slip.key) {
            let message = format!("{} is an empty text", slip.place);
            let diagnostic = Diagnostic::new(&RULE, message, at, "nothing is in it");
            report.push(slip.place.clone(), diagnostic.help("say it, or leave the key out"));
        }
    }
}
