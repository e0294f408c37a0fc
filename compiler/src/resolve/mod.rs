//! From what was written to what is: axes written out, references bound, PDOs laid out.
//!
//! What the types of the model can hold passes; whether it is sensible is for the rules to say. What they
//! cannot hold is reported here.

mod axes;
mod capacity;
mod closed;
mod configurations;
mod context;
mod coordinates;
mod derived;
mod device;
mod entries;
mod extent;
mod front;
mod kept;
mod mappability;
mod mapped;
mod modes;
mod named;
mod names;
mod numbered;
mod objects;
mod overlay;
mod pdos;
mod restated;
mod startup;
mod sync_managers;
mod units;
mod values;
mod words;
mod writes;

use crate::diagnostic::Diagnostics;
use crate::model::{Device, Family, Shared};
use crate::raw::Reading;

/// Devices as they are written, and as they hold.
#[derive(Debug)]
pub(crate) struct Resolved {
    /// As they are written: what rules judge.
    pub(crate) printed: Family,
    /// With what errata say instead: what outputs show. None if that is the same.
    pub(crate) held: Option<Family>,
}

/// Resolves all members of a family; none of it if one of them cannot be.
pub(crate) fn resolve(id: &str, members: Vec<Reading>, diagnostics: &mut Diagnostics) -> Option<Resolved> {
    let mut shared = None;
    let (mut printed, mut held, mut differs) = (Vec::new(), Vec::new(), false);
    let mut room = extent::Room::new();
    for Reading { printed: raw, corrected } in members {
        if !room.take(&raw, diagnostics) {
            return None;
        }
        shared = shared.or_else(|| raw.family.clone());
        let device = device::device(raw, diagnostics);
        if diagnostics.has_errors() {
            continue;
        }
        differs |= corrected.is_some();
        held.push(corrected.map(|raw| device::device(raw, diagnostics)));
        printed.extend(device);
    }
    if diagnostics.has_errors() || printed.is_empty() {
        return None;
    }
    let held = differs.then(|| {
        let members =
            printed.iter().zip(held).map(|(printed, held)| held.flatten().unwrap_or_else(|| printed.clone()));
        family(id, shared.as_ref(), members.collect())
    });
    Some(Resolved { printed: family(id, shared.as_ref(), printed), held })
}

fn family(id: &str, shared: Option<&Shared>, members: Vec<Device>) -> Family {
    let alone = members.first().map(|device| device.name.clone()).unwrap_or_default();
    let alone = || Shared { name: alone, ..Shared::default() };
    let Shared { name, about, source, origin } = shared.cloned().unwrap_or_else(alone);
    Family { id: id.to_owned(), name, about, source, members, origin }
}
