//! Where in a device a difference lies, and what is there.

use crate::model::{Address, Device, Entry, Index, Object, Pdo, Place, Repeated, Section, Shape};

/// The place that a path into a device names, as rules and errata name it.
pub(super) fn place(path: &[&str]) -> Place {
    match path {
        ["objects", _, "entries", entry, ..] => address(entry).map_or_else(Place::default, Place::from),
        ["objects" | "pdos", key, ..] => index(key).map_or_else(Place::default, Place::from),
        [field, rest @ ..] => section(field)
            .map_or_else(|| Section::Device.at(shown(field)), |section| in_section(section, rest)),
        [] => Place::default(),
    }
}

fn in_section(section: Section, rest: &[&str]) -> Place {
    let (place, rest) = match (section.shape(), rest) {
        (Shape::Single, rest) => (Place::from(section), rest),
        (_, [key, rest @ ..]) => (section.at(key), rest),
        (_, []) => (Place::from(section), rest),
    };
    rest.iter().fold(place, |place, step| place.at(shown(step)))
}

/// The section that a field of the model is made of.
fn section(field: &str) -> Option<Section> {
    Section::find(&shown(field))
}

/// A field as descriptions write it, or the place in a list without the zeros that sort it.
fn shown(field: &str) -> String {
    field.parse::<usize>().map_or_else(|_| field.replace('_', "-"), |place| place.to_string())
}

/// `0x6040`.
pub(super) fn index(text: &str) -> Option<Index> {
    u16::from_str_radix(text.strip_prefix("0x")?, 16).ok().map(Index)
}

/// `0x6040:00`.
pub(super) fn address(text: &str) -> Option<Address> {
    let (object, entry) = text.split_once(':')?;
    Some(Address { index: index(object)?, subindex: u8::from_str_radix(entry, 16).ok()? })
}

/// Two versions of a device.
#[derive(Debug, Clone, Copy)]
pub(super) struct Versions<'d> {
    pub(super) old: &'d Device,
    pub(super) new: &'d Device,
}

impl<'d> Versions<'d> {
    /// An object as it was and as it is.
    pub(super) fn object(self, key: &str) -> Option<(&'d Object, &'d Object)> {
        let index = index(key)?;
        Some((self.old.object(index)?, self.new.object(index)?))
    }

    /// An entry as it was and as it is.
    pub(super) fn entry(self, key: &str) -> Option<(&'d Entry, &'d Entry)> {
        let address = address(key)?;
        Some((self.old.entry(address)?, self.new.entry(address)?))
    }

    /// A PDO as it was and as it is.
    pub(super) fn pdo(self, key: &str) -> Option<(&'d Pdo, &'d Pdo)> {
        let index = index(key)?;
        Some((self.old.pdo(index)?, self.new.pdo(index)?))
    }

    /// What the thing at a place is called, in the new version if it is there.
    pub(super) fn name(self, path: &[&str]) -> Option<String> {
        let of = |device: &Device| match path {
            ["objects", _, "entries", entry, ..] => {
                device.entry(address(entry)?).map(|entry| entry.name.clone())
            }
            ["objects", key, ..] => device.object(index(key)?).map(|object| object.name.clone()),
            ["pdos", key, ..] => device.pdo(index(key)?).map(|pdo| pdo.name.clone()),
            ["modes", key, ..] => {
                device.modes.iter().find(|mode| mode.code.to_string() == *key).map(|mode| mode.name.clone())
            }
            ["errors", key, ..] => device
                .errors
                .iter()
                .find(|error| error.code.to_string() == *key)
                .map(|error| error.name.clone()),
            _ => None,
        };
        of(self.new).or_else(|| of(self.old))
    }

    /// The object or the PDO at a place, in the new version if it is there.
    pub(super) fn repeated(self, path: &[&str]) -> Option<&'d dyn Repeated> {
        let of = |device: &'d Device| -> Option<&'d dyn Repeated> {
            match path {
                ["objects", key, ..] => device.object(index(key)?).map(|object| object as &dyn Repeated),
                ["pdos", key, ..] => device.pdo(index(key)?).map(|pdo| pdo as &dyn Repeated),
                _ => None,
            }
        };
        of(self.new).or_else(|| of(self.old))
    }
}
