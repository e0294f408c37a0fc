//! What the profiles say of objects: what a description need not repeat.

use std::collections::BTreeMap;
use std::path::Path;

use super::super::read::one_line;
use super::super::toml::{Keys, Toml, set, set_some};
use super::words;
use crate::diagnostic::Diagnostics;
use crate::model::{DataType, Kind, Meaning};
use crate::raw::{self, RawEntry, RawObject, RawValues};
use crate::source::{Document, Memory, Sources, load};

/// What profiles have.
#[derive(Debug, Default)]
pub(super) struct Known {
    /// Objects by index.
    objects: BTreeMap<u16, RawObject>,
    /// Modes of operation by code, with the bits that announce them.
    modes: Vec<(i16, u8)>,
}

impl Known {
    /// What some profiles have: a description that mentions it all, and says nothing of it, is read.
    pub(super) fn of(profiles: &[&str]) -> Self {
        let head = format!("profiles = {}\n", Toml::texts(profiles.iter().copied()).inline());
        let mut found = Self::default();
        let Some((document, _)) = read(&head) else { return found };
        let mentions = |section: &str| {
            let all = document.profile.get(section).and_then(|all| all.node.table());
            let keys = all.into_iter().flat_map(|all| &all.members).map(|member| &member.key.name);
            let keys: String = keys.map(|key| format!("{key} = {{}}\n")).collect();
            format!("[{section}]\n{keys}")
        };
        let text = [head, mentions("objects"), mentions("modes")].concat();
        let Some((document, sources)) = read(&text) else { return found };
        for reading in raw::read(&document, "device", &sources, &mut Diagnostics::default()) {
            let modes = reading.printed.modes.iter();
            found.modes.extend(modes.filter_map(|mode| Some((mode.code, mode.supported_bit?))));
            found.objects.extend(reading.printed.objects.into_iter().map(|it| (it.index.0, it)));
        }
        found
    }

    pub(super) fn object(&self, index: u16) -> Option<Base<'_>> {
        self.objects.get(&index).map(Base)
    }

    /// The modes that a device announces, by code, with the bit of 0x6502 for it.
    pub(super) fn modes(&self) -> &[(i16, u8)] {
        &self.modes
    }
}

fn read(text: &str) -> Option<(Document, Sources)> {
    let loader = Memory::new().with("device/device.toml", text);
    let mut sources = Sources::default();
    let mut diagnostics = Diagnostics::default();
    let path = Path::new("device");
    let document = load(&loader, path, crate::profiles::ALL, &mut sources, &mut diagnostics)?;
    Some((document, sources))
}

/// What a profile says of an object.
#[derive(Debug, Clone, Copy)]
pub(super) struct Base<'k>(&'k RawObject);

impl Base<'_> {
    pub(super) fn kind(self) -> Kind {
        self.0.head.kind.unwrap_or(if self.0.entries.is_empty() { Kind::Var } else { Kind::Record })
    }

    pub(super) fn name(self) -> Option<String> {
        self.0.value.name.clone()
    }

    /// The word by which a description refers to it.
    pub(super) fn id(self) -> Option<String> {
        self.0.head.id.clone()
    }

    /// What it says of the value of a single one.
    pub(super) fn value(self) -> Keys {
        keys(&self.0.value)
    }

    /// The subindices that it describes.
    pub(super) fn subindices(self) -> Vec<u8> {
        self.0.entries.iter().map(|entries| entries.range.0).collect()
    }

    /// What it says of an entry, be it in its own table or for all of them.
    pub(super) fn entry(self, subindex: u8) -> Keys {
        let own =
            self.0.entries.iter().find(|entries| (entries.range.0..=entries.range.1).contains(&subindex));
        keys(&own.unwrap_or(&self.0.shared).value)
    }
}

/// The keys that an ESI file can say as well. A type without a length is none.
fn keys(entry: &RawEntry) -> Keys {
    let mut keys = Keys::new();
    let mut add = |name: &str, word: Option<String>| {
        if let Some(word) = word {
            set(&mut keys, name, Toml::Text(word));
        }
    };
    add("name", entry.name.clone());
    let parsed = entry.r#type.as_deref().and_then(|it| it.parse::<DataType>().ok());
    add("type", parsed.map(|it| if it == DataType::Text(0) { "STRING".to_owned() } else { it.to_string() }));
    add("access", entry.access.map(|it| words::access(it).to_owned()));
    add("pdo", entry.pdo.map(|it| words::mappable(it).to_owned()));
    add("category", entry.category.map(|it| words::category(it).to_owned()));
    add("written", entry.written.map(|it| words::window(it).to_owned()));
    add("about", entry.about.as_deref().map(one_line));
    if let Some(RawValues::Own(meanings)) = &entry.values {
        let meanings = meanings.iter().map(|it| (it.value.to_string(), meaning(it)));
        set(&mut keys, "values", Toml::Table(meanings.collect()));
    }
    for (name, is_so) in [("backup", entry.backup), ("setting", entry.setting)] {
        if let Some(is_so) = is_so {
            set(&mut keys, name, Toml::Bool(is_so));
        }
    }
    keys
}

fn meaning(meaning: &Meaning) -> Toml {
    let mut keys = vec![("name".to_owned(), Toml::text(&meaning.name))];
    set_some(&mut keys, "about", meaning.about.as_deref().map(|about| Toml::text(one_line(about))));
    Toml::Table(keys)
}
