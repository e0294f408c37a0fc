//! A description as tables of TOML, before they are laid out.

use std::collections::BTreeSet;

use super::super::toml::{Keys, Toml, get, set};

/// A table of a section, such as `[objects.0x6040]`.
#[derive(Debug, Default, Clone)]
pub(crate) struct Block {
    /// The section; `objects`, or `members.d300.objects` of a member of a family.
    pub(crate) section: String,
    /// The key in the section; none for a section that is one table.
    pub(crate) key: Option<String>,
    /// What was guessed of it, for a person to look at.
    pub(crate) remarks: Vec<String>,
    /// What it says; the last may be tables within it.
    pub(crate) keys: Keys,
}

/// A description in the parts that become files.
#[derive(Debug, Default)]
pub(crate) struct Draft {
    pub(crate) profiles: Vec<&'static str>,
    /// What was guessed and is about no table alone.
    pub(crate) remarks: Vec<String>,
    /// The picture that tools show.
    pub(crate) picture: Option<Vec<u8>>,
    /// What a profile brings and the device does not have.
    pub(crate) without: Vec<String>,
    /// What the device is and how it is reached.
    pub(crate) device: Vec<Block>,
    pub(crate) pdos: Vec<Block>,
    pub(crate) objects: Vec<Block>,
    pub(crate) diagnosis: Vec<Block>,
    /// What members of a family have of their own.
    pub(crate) members: Vec<Block>,
}

impl Block {
    pub(crate) fn new(section: &str, key: Option<String>, keys: Keys) -> Self {
        let section = section.to_owned();
        Self { section, key, remarks: Vec::new(), keys }
    }
}

impl Draft {
    /// Keeps those of the guesses that no table tells of.
    pub(crate) fn remark(&mut self, guessed: Vec<String>) {
        let parts = [&self.device, &self.pdos, &self.objects, &self.diagnosis, &self.members];
        let told: BTreeSet<&String> = parts.into_iter().flatten().flat_map(|block| &block.remarks).collect();
        let mut seen = BTreeSet::new();
        let others = guessed.iter().filter(|words| !told.contains(words) && seen.insert(*words));
        self.remarks = others.cloned().collect();
    }

    /// Says which file the picture of the device is in.
    pub(crate) fn picture_in(&mut self, file: &str) {
        if let Some(head) = self.device.first_mut() {
            set(&mut head.keys, "image", Toml::text(file));
        }
    }

    /// The name of the family, or of the device.
    pub(crate) fn name(&self) -> String {
        let head = self.device.first().and_then(|block| get(&block.keys, "name"));
        match head {
            Some(Toml::Text(name)) => name.clone(),
            _ => String::new(),
        }
    }
}
