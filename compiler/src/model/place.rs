//! What a statement is about.

use std::fmt;

use serde::de::{Deserialize, Deserializer, Error};

use super::compare::value;
use super::{Address, Index, Section, Shape};
use crate::source::{CanonicalKey, parts};

/// A section, a table of it, an entry of that, or a key: what rules find a fault at, what errata answer, what is
/// assumed.
///
/// - `0x6502` is an object with a single value, or an object as a whole; `0x5010:0A` one of its entries;
/// - `0x1601` is a PDO; `0x1601:04` what is mapped fourth, as in its mapping object;
/// - `states.fault`, `errors.0x3130`, `words.statusword.9`: a section, then the keys in it, as a description has them;
/// - `identity.revision`: a key of a section that is there once.
///
/// A number is the same in any spelling; subindices are hexadecimal.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// The section.
    pub section: Section,
    /// The table in it; none for the section as a whole, and where there is one table only.
    pub key: Option<CanonicalKey>,
    /// The first and the last entry of an object, or what is mapped at this place in a PDO.
    pub subindex: Option<(u8, u8)>,
    /// The keys from there.
    pub path: Option<String>,
}

value! { Place }

impl Place {
    /// A table of a section.
    pub fn table(section: Section, key: &str) -> Self {
        let key = (section.shape() != Shape::Single).then(|| CanonicalKey::of(key));
        Self { key, ..section.into() }
    }

    /// A key below this place.
    #[must_use]
    pub fn at(mut self, key: impl fmt::Display) -> Self {
        self.path = Some(match self.path {
            Some(path) => format!("{path}.{key}"),
            None => key.to_string(),
        });
        self
    }

    /// Another key of the same table.
    #[must_use]
    pub(crate) fn with(self, key: impl fmt::Display) -> Self {
        Self { path: Some(key.to_string()), ..self }
    }

    /// Reads a place as descriptions write it; none if there is no such section or no such number.
    pub fn parse(text: &str) -> Option<Self> {
        let mut keys = parts(text);
        let first = keys.next()?;
        let mut place = match first.strip_prefix("0x") {
            Some(address) => Self::of_address(address)?,
            None => Self::from(Section::find(first)?),
        };
        if place.key.is_none() && place.section.shape() != Shape::Single {
            place.key = keys.next().map(CanonicalKey::of);
        }
        Some(keys.fold(place, Self::at))
    }

    /// `6040` or `6040:0A`.
    fn of_address(text: &str) -> Option<Self> {
        let (index, subindex) = text.split_once(':').map_or((text, None), |(index, sub)| (index, Some(sub)));
        let place = Self::from(Index(u16::from_str_radix(index, 16).ok()?));
        let range = |text: &str| {
            let (first, last) = text.split_once("..=").unwrap_or((text, text));
            let number = |text| u8::from_str_radix(text, 16).ok();
            number(first).zip(number(last))
        };
        match subindex {
            Some(subindex) => Some(place.entries(range(subindex)?)),
            None => Some(place),
        }
    }

    /// Entries of an object.
    #[must_use]
    pub fn entries(self, range: (u8, u8)) -> Self {
        Self { subindex: Some(range), ..self }
    }
}

impl Section {
    /// A table of the section, or a key of its only one.
    pub fn at(self, key: impl fmt::Display) -> Place {
        match self.shape() {
            Shape::Single => Place::from(self).at(key),
            _ => Place::table(self, &key.to_string()),
        }
    }
}

impl<'de> Deserialize<'de> for Place {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let expected =
            "expected a place such as \"0x6040\", \"0x5010:0A\", \"states.fault\" or \"identity.revision\"";
        Self::parse(&text).ok_or_else(|| Error::custom(expected))
    }
}

#[cfg(feature = "json")]
impl serde::Serialize for Place {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// The description as a whole.
impl Default for Place {
    fn default() -> Self {
        Section::Device.into()
    }
}

impl From<Section> for Place {
    fn from(section: Section) -> Self {
        Self { section, key: None, subindex: None, path: None }
    }
}

impl From<Index> for Place {
    fn from(index: Index) -> Self {
        let section = match index.0 {
            0x1600..=0x17FF => Section::RxPdos,
            0x1A00..=0x1BFF => Section::TxPdos,
            _ => Section::Objects,
        };
        let number = i64::from(index.0);
        Self { key: Some(CanonicalKey::Range(number, number)), ..section.into() }
    }
}

impl From<Address> for Place {
    fn from(address: Address) -> Self {
        Self::from(address.index).entries((address.subindex, address.subindex))
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let by_index = matches!(self.section, Section::Objects | Section::RxPdos | Section::TxPdos);
        match &self.key {
            Some(CanonicalKey::Range(index, _)) if by_index => write!(f, "0x{index:04X}")?,
            None => f.write_str(self.section.name())?,
            Some(key) => {
                write!(f, "{}.", self.section.name())?;
                shown(f, key, self.section.shape())?;
            }
        }
        match self.subindex {
            Some((first, last)) if first == last => write!(f, ":{first:02X}")?,
            Some((first, last)) => write!(f, ":{first:02X}..={last:02X}")?,
            None => {}
        }
        self.path.as_ref().map_or(Ok(()), |path| write!(f, ".{path}"))
    }
}

/// A key as people write it in a section.
fn shown(f: &mut fmt::Formatter<'_>, key: &CanonicalKey, shape: Shape) -> fmt::Result {
    match (key, shape) {
        (CanonicalKey::Word(word), _) => f.write_str(word),
        (CanonicalKey::Range(first, last), Shape::Indices) if first == last => write!(f, "0x{first:04X}"),
        (CanonicalKey::Range(first, last), Shape::Indices) => write!(f, "0x{first:04X}..=0x{last:04X}"),
        (CanonicalKey::Range(first, last), _) if first == last => write!(f, "{first}"),
        (CanonicalKey::Range(first, last), _) => write!(f, "{first}..={last}"),
    }
}
