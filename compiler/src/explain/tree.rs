//! What can be asked.

use crate::diagnostic::Diagnostics;
use crate::source::{Node, Profile, Table, Value, read_profile};
use crate::text::Sources;

/// A tree with its name.
pub(super) struct Tree {
    pub(super) name: String,
    /// What it says of itself at its beginning.
    pub(super) about: String,
    pub(super) root: Table,
}

/// Several trees with the texts that they were read from.
pub(super) struct Trees {
    pub(super) trees: Vec<Tree>,
    sources: Sources,
}

impl Trees {
    /// Profiles, which are known to be well-formed.
    pub(super) fn of(profiles: &[Profile]) -> Self {
        let (mut sources, mut diagnostics) = (Sources::default(), Diagnostics::default());
        let tree = |profile: &Profile| Tree {
            name: profile.name.to_owned(),
            about: comment(profile.text),
            root: read_profile(profile, &mut sources, &mut diagnostics),
        };
        Self { trees: profiles.iter().map(tree).collect(), sources }
    }

    /// A description with what profiles say of what it mentions.
    pub(super) fn one(name: String, root: Table, sources: Sources) -> Self {
        let about = sources.get(root.at.file).map_or_else(String::new, |file| comment(&file.text));
        Self { trees: vec![Tree { name, about, root }], sources }
    }

    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.trees.iter().map(|tree| tree.name.as_str())
    }

    /// A value as it was written, a text without its quotes.
    pub(super) fn written(&self, node: &Node) -> String {
        match &node.value {
            Value::String(text) => text.to_string(),
            Value::Array(items) => items.iter().map(|item| self.written(item)).collect::<Vec<_>>().join(", "),
            _ => self.sources.slice(node.at).unwrap_or_default().to_owned(),
        }
    }
}

/// The comment that a text begins with, each paragraph as one line.
fn comment(text: &str) -> String {
    let lines = text.lines().map_while(|line| line.strip_prefix('#')).map(str::trim);
    let lines: Vec<&str> = lines.collect();
    let paragraphs = lines.split(|line| line.is_empty()).map(|lines| lines.join(" "));
    paragraphs.collect::<Vec<_>>().join("\n\n")
}
