//! What an editor asks while a description is written: what fits here, what this is, where it is defined.
//!
//! Texts are looked at as they are written, half a line included. What things there are, to be named, is taken from the
//! last compilation that could read the files.

mod axis_name;
mod complete;
mod define;
mod edit;
mod hover;
mod rename;
mod spot;
mod symbols;
mod thing;

use crate::compile::Compilation;
use crate::raw::over_profile;
use crate::source::{Sources, Table};

pub use complete::{Completion, complete, complete_beside};
pub use define::{Definition, define};
pub use edit::{Refusal, Renaming};
pub use hover::{Hover, hover};
pub use rename::{name_at, rename};
pub use symbols::{Symbol, symbols};

/// The things that a description and its profiles define, as far as its files could be read.
#[derive(Debug, Clone)]
pub struct Knowledge {
    /// The description over what its profiles say of what it mentions.
    root: Table,
    /// All that its profiles say.
    profile: Table,
    sources: Sources,
}

impl Knowledge {
    /// What a compilation has read; none if there was nothing to read.
    pub fn of(compilation: &Compilation) -> Option<Self> {
        let document = compilation.document.as_ref()?;
        let root = over_profile(&document.root, &document.profile);
        Some(Self { root, profile: document.profile.clone(), sources: compilation.sources.clone() })
    }

    /// The texts that places point into.
    pub fn sources(&self) -> &Sources {
        &self.sources
    }
}

/// The text of a profile that devc brings along.
pub fn profile(name: &str) -> Option<&'static str> {
    crate::profiles::ALL.iter().find(|profile| profile.name == name).map(|profile| profile.text)
}
