//! By what the rows of an area can be chosen: who may write, what PDOs map, and whether it is the profile's.

use std::collections::BTreeSet;

use crate::model::{Access, Entry, Mappable, Object, facts};
use crate::source::{Layer, Origin};

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
    let layers = |origin: &'o Origin| {
        facts(origin).into_iter().filter_map(move |(path, _)| Some(origin.layer(&path)? == Layer::Profile))
    };
    let is_profile: Vec<bool> = origins.into_iter().flat_map(layers).collect();
    match (is_profile.contains(&true), !is_profile.contains(&false)) {
        (true, true) => "profile",
        (true, false) => "changed",
        (false, _) => "own",
    }
}
