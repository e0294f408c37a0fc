//! By what the rows of an area can be chosen: who may write, what PDOs map, and whether it is the profile's.

use std::collections::BTreeSet;

use crate::model::{Access, Entry, Mappable, Object, Provenance, facts};
use crate::source::Origin;

/// The kinds of an object that is one value.
pub(super) fn single(object: &Object, entry: &Entry) -> BTreeSet<&'static str> {
    values(entry).into_iter().chain([said([&object.origin, &entry.origin])]).collect()
}

/// The kinds of an object with entries: those of all of them.
pub(super) fn compound(object: &Object) -> BTreeSet<&'static str> {
    object.entries.iter().flat_map(values).chain([said([&object.origin])]).collect()
}

/// The kinds of an entry of such an object.
pub(super) fn entry(entry: &Entry) -> BTreeSet<&'static str> {
    values(entry).into_iter().chain([said([&entry.origin])]).collect()
}

fn values(entry: &Entry) -> [&'static str; 2] {
    let access = match entry.access {
        Access::Ro => "ro",
        Access::Wo => "wo",
        Access::Rw => "rw",
        Access::Const => "const",
    };
    let mapped = match entry.pdo {
        Mappable::None => "unmapped",
        Mappable::Rx => "rx",
        Mappable::Tx => "tx",
        Mappable::RxTx => "rxtx",
    };
    [access, mapped]
}

/// Whether the profile says all, the description says something else than the profile, or the profile does not know it.
fn said<'o>(origins: impl IntoIterator<Item = &'o Origin>) -> &'static str {
    let facts: Vec<_> = origins.into_iter().flat_map(facts).collect();
    let is_profile = |(_, who): &(String, Provenance)| *who == Provenance::Profile;
    match (facts.iter().any(is_profile), facts.iter().all(is_profile)) {
        (true, true) => "profile",
        (true, false) => "changed",
        (false, _) => "own",
    }
}
