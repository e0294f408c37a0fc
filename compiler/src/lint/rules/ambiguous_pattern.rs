use std::collections::BTreeMap;

use crate::diagnostic::{Diagnostic, rule};
use crate::lint::Report;
use crate::model::{Device, Section};

rule! {
    /// Whoever sees a light looks for what it shows. If one light has two meanings for that, nobody can tell which of them
    /// holds.
    ///
    /// ## Fires
    /// ```toml
    /// [leds.run]
    /// name = "RUN"
    /// patterns = [
    ///     { shows = "blinking", means = "Pre-Operational" },
    ///     { shows = "Blinking", means = "Safe-Operational" },
    /// ]
    /// ```
    ///
    /// ## Silent
    /// ```toml
    /// [leds.run]
    /// name = "RUN"
    /// patterns = [
    ///     { shows = "blinking", means = "Pre-Operational" },
    ///     { shows = "single flash", means = "Safe-Operational" },
    /// ]
    /// ```
    pub(super) static RULE = "ambiguous-pattern", Facts, Warning, "a light shows one thing for two";
}

pub(super) fn check(device: &Device, report: &mut Report) {
    for led in &device.leds {
        let mut first = BTreeMap::new();
        for (i, pattern) in led.patterns.iter().enumerate() {
            let at = led.origin.value(&format!("patterns.{i}.shows"));
            let Some(other) = first.get(&pattern.shows.to_lowercase()) else {
                first.insert(pattern.shows.to_lowercase(), at);
                continue;
            };
            let message = format!("`{}` shows `{}` for two things", led.name, pattern.shows);
            let diagnostic = Diagnostic::new(&RULE, message, at, "again here")
                .label(*other, "first here")
                .help("say both in one pattern, or what tells them apart");
            report.push(Section::Leds.at(&led.id).at(format!("patterns.{i}")), diagnostic);
        }
    }
}
