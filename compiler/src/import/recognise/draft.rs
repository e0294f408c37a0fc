//! A description as tables of TOML, before they are laid out.

use super::super::toml::{Keys, Toml, get};

/// A table of a section, such as `[objects.0x6040]`.
#[derive(Debug, Default, Clone)]
pub(crate) struct Block {
    /// The section; `objects`, or `members.d300.objects` of a member of a family.
    pub(crate) section: String,
    /// The key in the section; none for a section that is one table.
    pub(crate) key: Option<String>,
    /// What a person should look at.
    pub(crate) remarks: Vec<String>,
    /// What it says; the last may be tables within it.
    pub(crate) keys: Keys,
}

/// A description in the parts that become files.
#[derive(Debug, Default)]
pub(crate) struct Draft {
    pub(crate) profiles: Vec<&'static str>,
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
    /// The name of the family, or of the device.
    pub(crate) fn name(&self) -> String {
        let head = self.device.first().and_then(|block| get(&block.keys, "name"));
        match head {
            Some(Toml::Text(name)) => name.clone(),
            _ => String::new(),
        }
    }
}
