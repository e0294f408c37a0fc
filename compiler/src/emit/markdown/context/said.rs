//! Who says a fact, and how sure it is: beside each source what the source does not state.

use std::collections::BTreeMap;

use super::super::inline::{link, list, small, text};
use super::Context;
use crate::model::{Assumption, Device, Erratum, Provenance, Source, assumption, facts, provenance};
use crate::source::{Layer, Origin};

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

    /// The same where a source is not worth a line: only with what it does not state.
    pub(in crate::emit::markdown) fn departures_line(
        &self,
        source: Option<&Source>,
        origin: &Origin,
    ) -> String {
        match self.editorial && !self.departures(origin).is_empty() {
            true => self.said_line(source, origin),
            false => String::new(),
        }
    }

    /// What a source does not state: by a profile, assumed, corrected, contradicted.
    fn departures(&self, origin: &Origin) -> Vec<String> {
        let mut facts = facts(origin);
        // what is mapped has marks of its own
        facts.retain(|(path, _)| !path.starts_with("entries."));
        let of_profile = facts.iter().filter(|(_, who)| *who == Provenance::Profile);
        let of_profile: Vec<&str> = of_profile.map(|(path, _)| path.as_str()).collect();
        let profile = (!of_profile.is_empty())
            .then(|| told("profile", None, &of_profile, of_profile.len() == facts.len()));
        let anchors = facts.iter().filter(|(_, who)| has_reason(who));
        let anchors: Vec<_> =
            anchors.map(|(path, who)| (path.as_str(), self.anchors(origin, path, who))).collect();
        let others = ["assumed", "corrected", "contradicted"].into_iter().filter_map(|kind| {
            let mut reasons: Vec<(&String, Vec<&str>)> = Vec::new();
            for (path, anchor) in anchors.iter().filter_map(|(path, of)| Some((*path, of.get(kind)?))) {
                match reasons.iter_mut().find(|(same, _)| *same == anchor) {
                    Some((_, paths)) => paths.push(path),
                    None => reasons.push((anchor, vec![path])),
                }
            }
            if let [(anchor, paths)] = reasons.as_slice() {
                let is_all = paths.len() == facts.len() && has_one_reason(origin);
                return Some(told(kind, Some(anchor), paths, kind == "assumed" && is_all));
            }
            let links = reasons.iter().map(|(anchor, paths)| linked(&names(paths), anchor));
            let links = list(links);
            (!links.is_empty()).then(|| format!("{kind}: {links}"))
        });
        profile.into_iter().chain(others).collect()
    }

    /// A mark behind a value that the source of its table does not state, linked to the reason.
    pub(in crate::emit::markdown) fn mark(&self, origin: &Origin, key: &str) -> String {
        if !self.editorial {
            return String::new();
        }
        let who = provenance(origin, key);
        if self.is_profile(origin, key) {
            return "<sup>†</sup>".to_owned();
        }
        let anchors = self.anchors(origin, key, &who).into_iter();
        let marks = anchors.map(|(kind, anchor)| {
            let label = if kind == "assumed" { "‡" } else { kind };
            format!("<sup>{}</sup>", linked(label, &anchor))
        });
        marks.collect()
    }

    /// Whether only the profile says so. That what it says of a thing holds at all can be assumed: that is marked once, where
    /// the thing is named.
    pub(in crate::emit::markdown) fn is_profile(&self, origin: &Origin, key: &str) -> bool {
        let is_of_thing = |assumption: &Assumption| match assumption.at.path.as_deref() {
            None => true,
            Some(path) => path == "entries" && key != "entries",
        };
        match provenance(origin, key) {
            Provenance::Profile => true,
            Provenance::Assumed(reason) => {
                origin.layer(key) == Some(Layer::Profile)
                    && assumed(self.device, origin, key, &reason).is_some_and(is_of_thing)
            }
            _ => false,
        }
    }

    /// The marks behind a value by several keys, each once.
    pub(in crate::emit::markdown) fn marks(&self, origin: &Origin, keys: &[&str]) -> String {
        once(keys.iter().map(|key| self.mark(origin, key)))
    }

    /// Where the reason, or the erratum, for a fact stands, by the word for it. Errata answer what is assumed, too. The
    /// anchor is empty where none is listed.
    fn anchors(&self, origin: &Origin, path: &str, who: &Provenance) -> BTreeMap<&'static str, String> {
        if !has_reason(who) {
            return BTreeMap::new();
        }
        let erratum = |number: u16| self.device.errata.get(usize::from(number)).map(erratum_id);
        let answer = match who {
            Provenance::Corrected(number) => Some(("corrected", erratum(*number).unwrap_or_default())),
            Provenance::Contradicted(number) => Some(("contradicted", erratum(*number).unwrap_or_default())),
            _ => None,
        };
        let reason = assumption(origin, path).map(|reason| {
            ("assumed", assumed(self.device, origin, path, reason).map(assumption_id).unwrap_or_default())
        });
        answer.into_iter().chain(reason).collect()
    }
}

/// Whether a reason or an erratum is behind a fact.
fn has_reason(who: &Provenance) -> bool {
    !matches!(who, Provenance::Stated | Provenance::Profile | Provenance::Derived)
}

/// Whether one reason is given for all of a table.
fn has_one_reason(origin: &Origin) -> bool {
    origin.node("assumed").is_some_and(|reasons| reasons.table().is_none())
}

/// Marks in a row, each once.
pub(in crate::emit::markdown) fn once(marks: impl Iterator<Item = String>) -> String {
    let mut all: Vec<String> = Vec::new();
    marks.for_each(|mark| {
        if !all.contains(&mark) {
            all.push(mark);
        }
    });
    all.concat()
}

/// What is said of some of the facts of a table, or of all of them.
fn told(kind: &str, anchor: Option<&str>, paths: &[&str], is_all: bool) -> String {
    let link = |label: &str| anchor.map_or_else(|| label.to_owned(), |anchor| linked(label, anchor));
    if is_all { link(kind) } else { format!("{kind}: {}", link(&names(paths))) }
}

/// Keys in running text.
fn names(paths: &[&str]) -> String {
    list(paths.iter().map(|path| text(path)))
}

fn linked(label: &str, anchor: &str) -> String {
    if anchor.is_empty() { label.to_owned() } else { link(label, anchor) }
}

/// The assumption behind a fact: the one about it, be it said of all of its table or of what that lies in. Where it is said
/// of another thing in the same words, that stands for it.
fn assumed<'d>(device: &'d Device, origin: &Origin, path: &str, reason: &str) -> Option<&'d Assumption> {
    let here = origin.header();
    let is_about = |assumption: &Assumption| {
        let rest = assumption.at.path.as_deref().map_or(Some(""), |own| path.strip_prefix(own));
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
    };
    let rank = |assumption: &&Assumption| {
        let there = assumption.origin.header();
        let is_around = there.file == here.file && there.start <= here.start;
        (there == here, is_around && is_about(assumption), is_around, there.start)
    };
    let same = device.assumptions.iter().filter(|assumption| assumption.reason == reason);
    same.max_by_key(rank)
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
