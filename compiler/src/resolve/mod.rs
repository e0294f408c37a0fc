//! From what was written to what is: axes written out, references bound, PDOs laid out.
//!
//! What the types of the model can hold passes; whether it is sensible is for the rules to say. What they
//! cannot hold is reported here.

mod axes;
mod configurations;
mod context;
mod coordinates;
mod derived;
mod device;
mod entries;
mod front;
mod kept;
mod modes;
mod names;
mod numbered;
mod objects;
mod overlay;
mod pdos;
mod startup;
mod sync_managers;
mod units;
mod values;
mod words;

use crate::diagnostic::Diagnostics;
use crate::model::{Family, Shared};
use crate::raw::RawDevice;

/// Resolves all members of a family; none of it if one of them cannot be.
pub(crate) fn resolve(
    id: &str,
    mut members: Vec<RawDevice>,
    diagnostics: &mut Diagnostics,
) -> Option<Family> {
    let family = members.first_mut().and_then(|device| device.family.take());
    let members: Vec<_> = members.into_iter().filter_map(|raw| device::device(raw, diagnostics)).collect();
    if diagnostics.has_errors() {
        return None;
    }
    let alone = members.first()?.name.clone();
    let (name, about) = family.map_or((alone, None), |Shared { name, about, .. }| (name, about));
    Some(Family { id: id.to_owned(), name, about, members })
}
