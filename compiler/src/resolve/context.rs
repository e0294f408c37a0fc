//! What every part of the resolver needs at hand.

use std::str::FromStr;

use super::names::{self, Names};
use crate::diagnostic::{Diagnostic, Diagnostics, Rule, faults};
use crate::model::{Address, Axis, Index, Object, Shift};
use crate::source::{Location, Origin};
use crate::text::near::{list, near};

/// The state of resolving one device.
pub(super) struct Context<'a> {
    pub(super) diagnostics: &'a mut Diagnostics,
    pub(super) names: Names,
    pub(super) axes: Vec<Axis>,
    pub(super) shifts: Vec<Shift>,
    pub(super) pdo_shift: u16,
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

    /// Reads a value, or reports that it cannot be read.
    pub(super) fn parse<T: FromStr>(&mut self, text: &str, expected: &str, at: Location) -> Option<T> {
        let value = text.parse().ok();
        if value.is_none() {
            self.invalid(text, expected, at);
        }
        value
    }

    /// Binds a reference to an object or an entry, or reports that there is none.
    pub(super) fn address(&mut self, text: &str, at: Location) -> Option<Address> {
        match self.names.find(text) {
            Some(address) => Some(address),
            None => {
                let has_room = self.diagnostics.has_room(&faults::UNKNOWN_REFERENCE);
                let near = has_room.then(|| self.names.near(text)).flatten();
                let message = format!("there is no object `{text}`");
                let fault = Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, at, "not in `[objects]`");
                self.diagnostics.push(match (near, names::index(text.split(':').next().unwrap_or(text))) {
                    (Some(near), _) => fault.fix(format!("there is `{near}`"), at, format!("\"{near}\"")),
                    (None, Some(index)) => fault
                        .note("an object of a profile is there once it is mentioned")
                        .help(format!("add `[objects.{index}]` with what the profile does not say")),
                    (None, None) => fault,
                });
                None
            }
        }
    }

    /// Reports that there is no PDO of this index.
    pub(super) fn no_pdo(&mut self, text: &str, at: Location, label: &str) {
        self.fault(&faults::UNKNOWN_REFERENCE, format!("there is no PDO `{text}`"), at, label);
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
        if known.iter().any(|name| name == text) {
            return true;
        }
        let message = format!("there is no {what} `{text}`");
        let mut fault = Diagnostic::new(&faults::UNKNOWN_REFERENCE, message, at, format!("not a {what}"));
        let has_room = self.diagnostics.has_room(&faults::UNKNOWN_REFERENCE);
        fault = match has_room.then(|| near(text, known.iter().map(String::as_str))).flatten() {
            Some(near) => fault.fix(format!("there is `{near}`"), at, format!("\"{near}\"")),
            None if known.is_empty() => fault.note(format!("the description has no {what}")),
            None => {
                let known: Vec<&str> = known.iter().map(String::as_str).collect();
                fault.note(format!("known are {}", list(&known)))
            }
        };
        self.diagnostics.push(fault);
        false
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

    /// The address on an axis of what `address` is on the first.
    pub(super) fn on_axis(&self, address: Address, axis: Option<u8>) -> Address {
        let shift = self.shifts.iter().find(|shift| (shift.first..=shift.last).contains(&address.index));
        let by = shift.zip(axis).map_or(0, |(shift, axis)| shift.by.wrapping_mul(axis.into()));
        Address { index: Index(address.index.0.wrapping_add(by)), ..address }
    }
}
