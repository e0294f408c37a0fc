//! Who says a fact, and how sure it is: beside each source what the source does not state.

use super::super::inline::{link, small, text};
use super::Context;
use crate::model::{Assumption, Device, Erratum, Provenance, Source, facts, provenance};
use crate::source::Origin;

impl Context<'_> {
    /// Where the facts of a table are from, in small print, with those that are not from there.
    pub(in crate::emit::markdown) fn said(&self, source: Option<&Source>, origin: &Origin) -> String {
        small(&self.parts(source, origin).join("; "))
    }

    /// The same in a line of its own.
    pub(in crate::emit::markdown) fn said_line(&self, source: Option<&Source>, origin: &Origin) -> String {
        let parts = self.parts(source, origin);
        match (parts.is_empty(), source) {
            (true, _) => String::new(),
            (false, Some(_)) => small(&format!("Source: {}", parts.join("; "))),
            (false, None) => small(&format!("No source; {}", parts.join("; "))),
        }
    }

    fn parts(&self, source: Option<&Source>, origin: &Origin) -> Vec<String> {
        let place = self.place(source);
        let departures = if self.editorial { self.departures(origin) } else { Vec::new() };
        Some(place).filter(|place| !place.is_empty()).into_iter().chain(departures).collect()
    }

    /// What a source does not state: by a profile, assumed, corrected, contradicted.
    fn departures(&self, origin: &Origin) -> Vec<String> {
        let facts = facts(origin);
        let of_profile: Vec<&str> = facts
            .iter()
            .filter(|(_, who)| *who == Provenance::Profile)
            .map(|(path, _)| path.as_str())
            .collect();
        let profile = match of_profile.as_slice() {
            [] => None,
            all if all.len() == facts.len() => Some("profile".to_owned()),
            some => Some(format!(
                "profile: {}",
                some.iter().map(|path| text(path)).collect::<Vec<_>>().join(", ")
            )),
        };
        let others = ["assumed", "corrected", "contradicted"].into_iter().filter_map(|kind| {
            let of_kind = facts.iter().filter(|(_, who)| word(who) == Some(kind));
            let reasons: Vec<String> =
                of_kind.map(|(path, who)| self.reason(origin, who, &text(path))).collect();
            (!reasons.is_empty()).then(|| format!("{kind}: {}", reasons.join(", ")))
        });
        profile.into_iter().chain(others).collect()
    }

    /// A mark behind a value that the source of its table does not state, linked to the reason.
    pub(in crate::emit::markdown) fn mark(&self, origin: &Origin, key: &str) -> String {
        let who = provenance(origin, key);
        match (self.editorial, &who) {
            (true, Provenance::Profile) => "<sup>†</sup>".to_owned(),
            (true, Provenance::Assumed(_)) => format!("<sup>{}</sup>", self.reason(origin, &who, "‡")),
            (true, Provenance::Corrected(_)) => {
                format!("<sup>{}</sup>", self.reason(origin, &who, "corrected"))
            }
            (true, Provenance::Contradicted(_)) => {
                format!("<sup>{}</sup>", self.reason(origin, &who, "contradicted"))
            }
            _ => String::new(),
        }
    }

    /// A label, linked to the assumption or the erratum behind a fact.
    fn reason(&self, origin: &Origin, who: &Provenance, label: &str) -> String {
        let erratum = |number: u16| self.device.errata.get(usize::from(number)).map(erratum_id);
        let anchor = match who {
            Provenance::Assumed(reason) => assumption(self.device, origin, reason).map(assumption_id),
            Provenance::Corrected(number) | Provenance::Contradicted(number) => erratum(*number),
            _ => None,
        };
        anchor.map_or_else(|| label.to_owned(), |anchor| link(label, anchor))
    }
}

fn word(who: &Provenance) -> Option<&'static str> {
    match who {
        Provenance::Assumed(_) => Some("assumed"),
        Provenance::Corrected(_) => Some("corrected"),
        Provenance::Contradicted(_) => Some("contradicted"),
        Provenance::Stated | Provenance::Profile | Provenance::Derived => None,
    }
}

/// The assumption with this reason, of the table itself if it has one.
fn assumption<'d>(device: &'d Device, origin: &Origin, reason: &str) -> Option<&'d Assumption> {
    let same = || device.assumptions.iter().filter(|assumption| assumption.reason == reason);
    same().find(|assumption| assumption.origin.header() == origin.header()).or_else(|| same().next())
}

/// The anchor of an assumption.
pub(in crate::emit::markdown) fn assumption_id(assumption: &Assumption) -> String {
    format!("assumed-{}", slug(&assumption.at.to_string()))
}

/// The anchor of an erratum.
pub(in crate::emit::markdown) fn erratum_id(erratum: &Erratum) -> String {
    format!("erratum-{}-{}", erratum.rule, slug(&erratum.at.to_string()))
}

fn slug(text: &str) -> String {
    text.to_lowercase().replace(|c: char| !c.is_ascii_alphanumeric(), "-")
}
