use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Place, Section};
use crate::source::Location;

rule! {
    /// Some tables are there for one list: a telegram for its bytes, a procedure for its steps, a limit of cycle times for the
    /// times. Without it they stand in the outputs with a name and nothing below it.
    ///
    /// ## Fires
    /// ```toml
    /// [procedures.start]
    /// name = "Start the drive"
    /// steps = []
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [procedures.start]
    /// name = "Start the drive"
    /// steps = [{ do = "Switch it on." }]
    /// ```
    pub(super) static RULE = "hollow-table", Facts, Warning, "a table lacks what it is there for";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for (place, at, lacks) in hollow(device) {
        let message = format!("{place} has {lacks}");
        let diagnostic = Diagnostic::new(&RULE, message, at, "nothing is in it");
        report.push(place, diagnostic.help("say what belongs to it, or take it out"));
    }
}

/// The tables that say nothing, and what they lack.
fn hollow(device: &Device) -> Vec<(Place, Location, &'static str)> {
    let mut hollow = Vec::new();
    macro_rules! hollow {
        ($($field:ident by $id:ident: $section:ident, $is_hollow:expr, $lacks:literal;)+) => {
            $(
                let found = device.$field.iter().filter($is_hollow);
                hollow.extend(found.map(|it| (Section::$section.at(&it.$id), it.origin.header(), $lacks)));
            )+
        };
    }
    hollow! {
        telegrams by id: Telegrams, |it| it.fields.is_empty(), "no bytes";
        procedures by id: Procedures, |it| it.steps.is_empty(), "no steps";
        cycle_times by id: CycleTimes, |it| it.min.is_none() && it.choices.is_empty() && it.about.is_none(),
            "neither `min` nor `choices`";
        enumerations by id: Enumerations, |it| it.values.is_empty(), "no values";
    }
    hollow
}
