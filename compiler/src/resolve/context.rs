//! What every part of the resolver needs at hand.

use super::names::{self, Names, Unknown};
use crate::diagnostic::{Diagnostic, Diagnostics, Rule, faults};
use crate::model::{Address, Axis, Enumeration, Index, Meanings, Object, Section, Shift};
use crate::raw::RawValues;
use crate::source::{Location, Origin};
use crate::text::near::{list, meant};

/// How many entries a message names.
const MOST_NAMED: usize = 6;

/// Says that there is a name which is like the one that is not there. Only a slip is mended without asking.
fn there_is(fault: Diagnostic, name: &str, is_plain: bool, at: Location) -> Diagnostic {
    instead(fault, name, is_plain, at, format!("\"{name}\""))
}

/// The same for a name that is written as `edit`.
fn instead(fault: Diagnostic, name: &str, is_plain: bool, at: Location, edit: String) -> Diagnostic {
    let text = format!("there is `{name}`");
    if is_plain { fault.fix(text, at, edit) } else { fault.suggest(text, at, edit) }
}

/// The state of resolving one device.
pub(super) struct Context<'a> {
    pub(super) diagnostics: &'a mut Diagnostics,
    pub(super) names: Names,
    pub(super) axes: Vec<Axis>,
    pub(super) shifts: Vec<Shift>,
    pub(super) pdo_shift: u16,
    /// The PDOs that each axis has, by that of the first.
    pub(super) pdos_of_axes: Vec<Index>,
    pub(super) enumerations: Vec<Enumeration>,
}

impl Context<'_> {
    /// Reports a fault at a place.
    pub(super) fn fault(&mut self, rule: &'static Rule, message: String, at: Location, label: &str) {
        self.diagnostics.push(Diagnostic::new(rule, message, at, label));
    }

    /// Reports a value that cannot be read, and says what could.
    pub(super) fn invalid(&mut self, text: &str, expected: &str, at: Location) {
        let message = format!("`{text}` means nothing here");
        self.fault(&faults::INVALID_VALUE, message, at, &format!("expected {expected}"));
    }

    /// Binds a reference to an object or an entry, or reports that there is none.
    pub(super) fn address(&mut self, text: &str, at: Location) -> Option<Address> {
        match self.names.find(text) {
            Ok(address) => Some(address),
            Err(unknown) => {
                self.unknown(text, &unknown, at);
                None
            }
        }
    }

    /// Reports a reference to no object and no entry.
    fn unknown(&mut self, text: &str, unknown: &Unknown, at: Location) {
        if let Unknown::Several(entries) = unknown {
            let message = format!("`{text}` stands for several entries");
            let fault = Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, at, "which of them is not said");
            let known: Vec<String> = entries.iter().map(Address::to_string).collect();
            let known: Vec<&str> = known.iter().map(String::as_str).collect();
            let fault = fault.note(format!("it is {}", list(&known)));
            self.diagnostics.push(fault.help("write the address of the one that is meant"));
            return;
        }
        let object = text.split(':').next().unwrap_or(text);
        let has_room = self.diagnostics.has_room(&faults::UNKNOWN_REFERENCE);
        let near = has_room.then(|| self.names.near(object)).flatten();
        let message = format!("there is no object `{text}`");
        let fault = Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, at, "not in `[objects]`");
        let index = names::index(object).or_else(|| self.names.offered(object));
        self.diagnostics.push(match (near, index) {
            (Some((name, is_plain)), None) => there_is(fault, &name, is_plain, at),
            (_, Some(index)) => fault
                .note("an object of a profile is there once it is mentioned")
                .help(format!("add `[objects.{index}]` with what the profile does not say")),
            (None, None) => match self.names.near_offered(object).filter(|_| has_room) {
                Some((name, index)) => fault
                    .note(format!(
                        "a profile has `{name}`; an object of a profile is there once it is mentioned"
                    ))
                    .help(format!("if that is meant, write its name and add `[objects.{index}]`")),
                None => fault,
            },
        });
    }

    /// Reports that a PDO maps an object of several entries, and does not say which.
    pub(super) fn several_entries(&mut self, text: &str, object: &Object, at: Location) {
        let message = format!("`{text}` has several entries, and one can be mapped at a time");
        let fault = Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, at, "which of them is not said");
        let entries = object.entries.iter().skip(1).take(MOST_NAMED);
        let entries = entries.map(|entry| format!("`{}` {}", entry.address, entry.name));
        let more = if object.entries.len() > MOST_NAMED + 1 { ", ..." } else { "" };
        let entries = format!("it has {}{more}", entries.collect::<Vec<_>>().join(", "));
        let fault = fault.label(object.origin.header(), "this object").note(entries);
        self.diagnostics.push(fault.help(format!("write a subindex behind it, such as `{text}:01`")));
    }

    /// Reports that there is no PDO of this index.
    pub(super) fn no_pdo(&mut self, text: &str, at: Location, label: &str) {
        self.fault(&faults::UNKNOWN_REFERENCE, format!("there is no PDO `{text}`"), at, label);
    }

    /// Reports that a list that names the PDOs of the first axis does not name one that is described.
    pub(super) fn no_described_pdo(&mut self, text: &str, at: Location, label: &str) {
        let Some((first, axis)) = names::index(text).and_then(|index| self.of_another_axis(index)) else {
            return self.no_pdo(text, at, label);
        };
        let message =
            format!("`{text}` is the PDO of axis `{axis}`, and that of the first axis stands for all");
        let fault = Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, at, "not of the first axis");
        self.diagnostics.push(fault.help(format!("write \"{first}\" once: each axis has its own by that")));
    }

    /// That of another axis, by the PDO of the first.
    pub(super) fn pdo_on(&self, first: Index, axis: u8) -> Index {
        Index(first.0.wrapping_add(self.pdo_shift.wrapping_mul(axis.into())))
    }

    /// The PDO of the first axis, and the name of the axis, if a PDO is that of another axis.
    fn of_another_axis(&self, index: Index) -> Option<(Index, &str)> {
        let others = || self.axes.iter().skip(1);
        self.pdos_of_axes.iter().find_map(|first| {
            let axis = others().find(|axis| self.pdo_on(*first, axis.number) == index)?;
            Some((*first, axis.name.as_str()))
        })
    }

    /// Reports that an object lacks an entry that something refers to.
    pub(super) fn no_entry(&mut self, object: &Object, address: Address, at: Location) {
        let message = format!("{} has no subindex {:02X}", object.index, address.subindex);
        let label = format!("`{}` ends at {:02X}", object.id, object.highest_subindex());
        let fault = Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, at, label);
        let fault = fault.label(object.origin.header(), "this object");
        let decimal = format!("{:X}", address.subindex).parse().ok();
        self.diagnostics.push(match decimal.filter(|decimal| object.entry(*decimal).is_some()) {
            Some(decimal) => {
                fault.help(format!("subindices are hexadecimal: entry {decimal} is `:{decimal:02X}`"))
            }
            None => fault,
        });
    }

    /// Binds a list of references, reporting each that cannot be.
    pub(super) fn addresses(&mut self, list: &[String], origin: &Origin, path: &str) -> Vec<Address> {
        let places = list.iter().enumerate();
        places.filter_map(|(i, text)| self.address(text, origin.value(&format!("{path}.{i}")))).collect()
    }

    /// Whether a reference names one of several things; reports it if it does not.
    pub(super) fn bind(&mut self, text: &str, known: &[String], what: &str, at: Location) -> bool {
        let fault = self.unbound(text, known, what, at, |name| format!("\"{name}\""));
        self.is_bound(fault)
    }

    /// Binds a reference to a table of a section, or reports that there is none and how to write it.
    pub(super) fn bind_to(
        &mut self,
        section: Section,
        text: &str,
        known: &[String],
        what: &str,
        at: Location,
    ) {
        if let Some(fault) = self.unbound(text, known, what, at, |name| format!("\"{name}\"")) {
            self.diagnostics.push(fault.help(format!("describe it in `[{}.{text}]`", section.name())));
        }
    }

    /// Whether a key names one of several things; reports it if it does not.
    pub(super) fn bind_key(&mut self, text: &str, known: &[String], what: &str, at: Location) -> bool {
        let fault = self.unbound(text, known, what, at, str::to_owned);
        self.is_bound(fault)
    }

    /// Whether nothing was wrong; reports it if something was.
    fn is_bound(&mut self, fault: Option<Diagnostic>) -> bool {
        let is_bound = fault.is_none();
        fault.into_iter().for_each(|fault| self.diagnostics.push(fault));
        is_bound
    }

    /// What is wrong with a word that names none of several things.
    fn unbound(
        &self,
        text: &str,
        known: &[String],
        what: &str,
        at: Location,
        written: impl Fn(&str) -> String,
    ) -> Option<Diagnostic> {
        if known.iter().any(|name| name == text) {
            return None;
        }
        let message = format!("there is no {what} `{text}`");
        let article = if what.starts_with(['a', 'e', 'i', 'o']) { "an" } else { "a" };
        let fault = Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, at, format!("not {article} {what}"));
        let has_room = self.diagnostics.has_room(&faults::UNKNOWN_REFERENCE);
        Some(match has_room.then(|| meant(text, known.iter().map(String::as_str))).flatten() {
            Some((near, is_plain)) => instead(fault, near, is_plain, at, written(near)),
            None if known.is_empty() => fault.note(format!("the description has no {what}")),
            None => {
                let known: Vec<&str> = known.iter().map(String::as_str).collect();
                fault.note(format!("known are {}", list(&known)))
            }
        })
    }

    /// What single values mean, there or in an enumeration; nothing if there is no such enumeration.
    pub(super) fn meanings(&self, raw: &RawValues) -> Meanings {
        match raw {
            RawValues::Own(meanings) => meanings.clone(),
            RawValues::Shared(name) => {
                let known = self.enumerations.iter().find(|enumeration| enumeration.id == *name);
                known.map(|known| known.values.clone()).unwrap_or_default()
            }
        }
    }

    /// The numbers of the axes with the distance of their copy of an index from the first axis' one; no
    /// axis if the object exists once.
    pub(super) fn copies(&self, index: Index) -> Vec<(Option<u8>, u16)> {
        let shift = self.shifts.iter().find(|shift| (shift.first..=shift.last).contains(&index));
        match shift {
            None => vec![(None, 0)],
            Some(shift) => {
                self.axes.iter().map(|axis| (Some(axis.number), shift.by * u16::from(axis.number))).collect()
            }
        }
    }

    /// What an object of an axis means by `address`: that of its axis. An object that is there once means that of each axis.
    pub(super) fn reached(&self, address: Address, axis: Option<u8>) -> Vec<Address> {
        let axes = match axis {
            Some(axis) => vec![Some(axis)],
            None => self.copies(address.index).into_iter().map(|(axis, _)| axis).collect(),
        };
        axes.into_iter().map(|axis| self.on_axis(address, axis)).collect()
    }

    /// The address on an axis of what `address` is on the first.
    pub(super) fn on_axis(&self, address: Address, axis: Option<u8>) -> Address {
        let shift = self.shifts.iter().find(|shift| (shift.first..=shift.last).contains(&address.index));
        let by = shift.zip(axis).map_or(0, |(shift, axis)| shift.by.wrapping_mul(axis.into()));
        Address { index: Index(address.index.0.wrapping_add(by)), ..address }
    }
}
