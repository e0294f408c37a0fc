//! What can be mapped, where it follows from the PDOs because no mapping can be changed.

use std::collections::BTreeSet;

use super::super::read::Pdo;
use super::super::toml::{Toml, get};
use super::described::Described;
use super::profile::{Base, Known};
use super::value::Said;
use super::words;
use crate::model::{Kind, Mappable};

/// Leaves out of objects what can be mapped, where all of their values can be where the PDOs have them and nowhere else: a
/// description that is silent means that.
pub(super) fn leave_out(described: &mut [Described], [rx, tx]: [&[&Pdo]; 2], known: &Known) {
    if rx.is_empty() && tx.is_empty() || !rx.iter().chain(tx).all(|pdo| pdo.fixed) {
        return;
    }
    let places = |pdos: &[&Pdo]| -> BTreeSet<(u16, u8)> {
        pdos.iter().flat_map(|pdo| &pdo.entries).map(|entry| (entry.index, entry.subindex)).collect()
    };
    let carried = [places(rx), places(tx)];
    for object in described {
        let base = known.object(object.index);
        let is_alike = base.is_none_or(|base| base.kind() == object.kind);
        let follows = |value: &Said| {
            let is_carried = carried.each_ref().map(|it| it.contains(&(object.index, value.subindex)));
            let meant = base.map(|base| of_profile(base, object.kind, value.subindex));
            let [rx, tx] = match meant.flatten() {
                Some(meant) => [is_carried[0] && meant.rx(), is_carried[1] && meant.tx()],
                None => is_carried,
            };
            get(&value.keys, "pdo") == Some(&Toml::text(words::mappable(Mappable::of(rx, tx))))
        };
        let kind = object.kind;
        let is_entry = |value: &Said| kind == Kind::Var || value.subindex > 0;
        if is_alike && object.values.iter().filter(|it| is_entry(it)).all(follows) {
            object
                .values
                .iter_mut()
                .filter(|it| is_entry(it))
                .for_each(|value| value.keys.retain(|(name, _)| name != "pdo"));
        }
    }
}

/// What a profile says of it.
fn of_profile(base: Base<'_>, kind: Kind, subindex: u8) -> Option<Mappable> {
    let keys = if kind == Kind::Var { base.value() } else { base.entry(subindex) };
    match get(&keys, "pdo")? {
        Toml::Text(word) => [Mappable::None, Mappable::Rx, Mappable::Tx, Mappable::RxTx]
            .into_iter()
            .find(|it| words::mappable(*it) == word),
        _ => None,
    }
}
