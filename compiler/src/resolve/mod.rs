//! From what was written to what is: axes written out, references bound, PDOs laid out.
//!
//! What the types of the model can hold passes; whether it is sensible is for the rules to say. What they
//! cannot hold is reported here.

mod axes;
mod configurations;
mod context;
mod control;
mod derived;
mod device;
mod entries;
mod errors;
mod facts;
mod front;
mod homing;
mod ids;
mod keys;
mod modes;
mod names;
mod numbered;
mod objects;
mod overlay;
mod parameters;
mod pdos;
mod registers;
mod startup;
mod states;
mod timing;
mod transport;
mod units;
mod values;
mod words;

use crate::diagnostic::Diagnostics;
use crate::model::Family;
use crate::raw::{RawDevice, RawFamily};
use crate::source::Sources;

/// Resolves all members of a family; none of it if one of them cannot be.
pub(crate) fn resolve(
    id: &str,
    family: Option<RawFamily>,
    members: Vec<RawDevice>,
    sources: &Sources,
    diagnostics: &mut Diagnostics,
) -> Option<Family> {
    let members: Vec<_> = members.into_iter().map(|raw| device::device(raw, sources, diagnostics)).collect();
    if diagnostics.has_errors() || members.is_empty() {
        return None;
    }
    let alone = members.first().map_or_else(String::new, |device| device.name.clone());
    let (name, about) = family.map_or((alone, None), |family| (family.name, family.about));
    Some(Family { id: id.to_owned(), name, about, members })
}
