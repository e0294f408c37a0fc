use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::{Report, texts};
use crate::model::{Device, Section};

rule! {
    /// People choose a configuration, a way to keep time, a module or a procedure by its name, and tell sockets by what is
    /// printed beside them. Of two that have one name, nobody knows which is which. Two lights may have one name, if they
    /// are told by their colours. So it is with states, commands and modes, which a log shows by their names.
    ///
    /// ## Fires
    /// ```toml
    /// [procedures]
    /// start = { name = "Reference the axis", steps = [{ do = "Move to the switch." }] }
    /// again = { name = "Reference the axis", steps = [{ do = "Move to the mark." }] }
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [procedures]
    /// start = { name = "Reference the axis", steps = [{ do = "Move to the switch." }] }
    /// again = { name = "Reference the axis again", steps = [{ do = "Move to the mark." }] }
    /// ```
    pub(super) static RULE = "ambiguous-choice", Facts, Warning, "two things to choose from have one name";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    let mut first = BTreeMap::new();
    let told_by_colour = |named: &texts::Named<'_>| named.at.section == Section::Leds;
    let all = texts::choices(device).into_iter().chain(texts::of_machine(device));
    for named in all.filter(|named| !told_by_colour(named)) {
        let name = named.name.trim().to_lowercase();
        let place = named.origin.value(&named.path);
        if name.is_empty() {
            continue; // `empty-name` judges it
        }
        let Some((other, label)) = first.get(&(named.at.section, name.clone())) else {
            first.insert((named.at.section, name), (named.at, place));
            continue;
        };
        let message = format!("{other} and {} are both called `{}`", named.at, named.name);
        let diagnostic = Diagnostic::new(&RULE, message, place, "the same name")
            .label(*label, "here, too")
            .help("add a word to one of them that tells them apart");
        report.push(named.at, diagnostic);
    }
}
