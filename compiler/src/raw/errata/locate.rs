//! Where in the tree a place is.

use super::{Step, at};
use crate::model::{Index, Place, Section};
use crate::raw::RawDevice;
use crate::source::{CanonicalKey, Node, Table, Value, keys, parts};

/// The tree of a device with what it was decoded to.
pub(super) struct Locate<'a> {
    pub(super) tree: &'a Table,
    pub(super) device: &'a RawDevice,
}

impl Locate<'_> {
    /// The keys from the root to a place; none if nothing stands there.
    pub(super) fn path(&self, place: &Place) -> Option<Vec<Step>> {
        let mut path = vec![Step::Key(place.section.name().to_owned())];
        match (place.section, &place.key) {
            (Section::Objects, Some(CanonicalKey::Range(index, _))) => {
                self.object(Index(u16::try_from(*index).ok()?), place, &mut path)?;
            }
            (Section::RxPdos | Section::TxPdos, Some(CanonicalKey::Range(index, _))) => {
                path.push(Step::Key(self.leading_pdo(place.section, *index)?));
                path.extend(place.subindex.iter().flat_map(|(first, _)| mapped(*first)));
            }
            (_, Some(key)) => path.push(self.key(place.section, key)?),
            (_, None) => {}
        }
        for key in place.path.iter().flat_map(|path| parts(path)) {
            self.step(&mut path, key);
        }
        at(self.tree, &path).is_some().then_some(path)
    }

    /// The key of an object; on another axis than the first the key of what differs there.
    fn object(&self, index: Index, place: &Place, path: &mut Vec<Step>) -> Option<()> {
        let described = |index| self.device.objects.iter().find(|object| object.index == index);
        let (leading, axis) = match described(index) {
            Some(_) => (index, None),
            None => self.device.axes.as_ref()?.leading(index)?,
        };
        let object = described(leading)?;
        path.push(Step::Key(object.key.clone()));
        let differing = axis.and_then(|axis| {
            let names = object.per_axis.iter().map(|(names, _)| names);
            names
                .into_iter()
                .find(|names| self.device.axes.as_ref().is_some_and(|axes| axes.has(names, axis)))
        });
        path.extend(
            differing.into_iter().flat_map(|names| [Step::Key("per-axis".into()), Step::Key(names.clone())]),
        );
        if let Some((first, _)) = place.subindex
            && let Some(entries) = self.entries(path, first)
        {
            path.extend([Step::Key("entries".to_owned()), Step::Key(entries)]);
        }
        Some(())
    }

    /// The key of the table in which an entry is described. An object with a single value has none.
    fn entries(&self, object: &[Step], subindex: u8) -> Option<String> {
        let entries = at(self.tree, object)?.table()?.get("entries")?.node.table()?;
        let covers = |key: &str| keys::range::<u8>(key).is_some_and(|range| range.contains(&subindex));
        let names = entries.members.iter().map(|member| &*member.key.name);
        names.filter(|name| covers(name)).map(str::to_owned).next()
    }

    /// The key of the PDO that is described for all axes.
    fn leading_pdo(&self, section: Section, index: i64) -> Option<String> {
        let pdos = if section == Section::RxPdos { &self.device.rx_pdos } else { &self.device.tx_pdos };
        let shift = self.device.axes.as_ref().map_or(0x10, |axes| i64::from(axes.pdo_shift.unwrap_or(0x10)));
        let axes = self.device.axes.as_ref().map_or(1, |axes| axes.names.len().max(1));
        let found = pdos.iter().find(|pdo| {
            let copies = if pdo.per_axis { axes } else { 1 };
            let first = keys::number(&pdo.key).unwrap_or(-1);
            (0_i64..).take(copies).any(|axis| first + axis * shift == index)
        });
        found.map(|pdo| pdo.key.clone())
    }

    /// A key of a section as it is written there, or the place in its list.
    fn key(&self, section: Section, key: &CanonicalKey) -> Option<Step> {
        let node = &self.tree.get(section.name())?.node;
        if let (Value::Array(_), CanonicalKey::Range(place, _)) = (&node.value, key) {
            return Some(Step::Item(usize::try_from(*place).ok()?));
        }
        let members = &node.table()?.members;
        let written = members.iter().find(|member| member.key.canonical == *key)?;
        Some(Step::Key(written.key.name.to_string()))
    }

    /// Goes on by a key. The bits of a word are named without the key that they all stand under.
    fn step(&self, path: &mut Vec<Step>, key: &str) {
        let here: Option<&Node> = at(self.tree, path);
        let step = match (here.map(|node| &node.value), key.parse()) {
            (Some(Value::Array(_)), Ok(place)) => Step::Item(place),
            _ => Step::Key(key.to_owned()),
        };
        let table = here.and_then(Node::table);
        let holder = ["bits", "bytes"].into_iter().find(|holder| {
            let inner = |table: &Table| table.get(holder).and_then(|bits| bits.node.table().cloned());
            table.is_some_and(|table| {
                table.get(key).is_none() && inner(table).is_some_and(|bits| bits.get(key).is_some())
            })
        });
        path.extend(holder.map(|holder| Step::Key(holder.to_owned())));
        path.push(step);
    }
}

/// What is mapped in a place of a PDO, counted as in its mapping object.
fn mapped(subindex: u8) -> Vec<Step> {
    let place = usize::from(subindex).checked_sub(1);
    place.map_or_else(Vec::new, |place| vec![Step::Key("entries".to_owned()), Step::Item(place)])
}
