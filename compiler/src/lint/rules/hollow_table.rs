use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{CycleTime, Device, Place, Section};
use crate::source::Location;

rule! {
    /// Some tables are there for one list: a telegram for its bytes, a procedure for its steps, a limit of cycle times for the
    /// times, a configuration for what it chooses. Without it they stand in the outputs with a name and nothing below it. Only the
    /// configuration that is the default can leave all as it is.
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
fn hollow(device: &Device) -> impl Iterator<Item = (Place, Location, &'static str)> {
    let telegrams = device.telegrams.iter().filter(|it| it.fields.is_empty());
    let telegrams = telegrams.map(|it| (Section::Telegrams.at(&it.id), it.origin.header(), "no bytes"));
    let procedures = device.procedures.iter().filter(|it| it.steps.is_empty());
    let procedures = procedures.map(|it| (Section::Procedures.at(&it.id), it.origin.header(), "no steps"));
    let says_nothing = |it: &&CycleTime| it.min.is_none() && it.choices.is_empty() && it.about.is_none();
    let times = device.cycle_times.iter().filter(says_nothing);
    let lacks = "neither `min` nor `choices`";
    let times = times.map(move |it| (Section::CycleTimes.at(&it.id), it.origin.header(), lacks));
    let enumerations = device.enumerations.iter().filter(|it| it.values.is_empty());
    let enumerations =
        enumerations.map(|it| (Section::Enumerations.at(&it.id), it.origin.header(), "no values"));
    let choices =
        device.configurations.iter().filter(|it| !it.chooses_anything() && !it.default && it.about.is_none());
    let choices = choices.map(|it| (Section::Configurations.at(&it.id), it.origin.header(), "no choice"));
    telegrams.chain(procedures).chain(choices).chain(times).chain(enumerations)
}
