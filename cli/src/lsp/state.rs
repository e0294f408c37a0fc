//! What is open in the editor, and what is known of it.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use devc::Compilation;
use devc::assist::Knowledge;
use devc::source::{Disk, Loader, MAIN_FILE, owner};
use lsp_server::{Message, Notification};

use super::overlay::Overlay;
use super::profiles::Profiles;
use super::text::Text;
use super::uri;
use super::worker::Job;

/// A text in the editor.
pub(super) struct Open {
    /// The file as the editor names it.
    pub(super) uri: String,
    pub(super) text: Text,
    pub(super) version: i32,
    /// The `device.toml` of its description; none if it is of none.
    pub(super) main: Option<PathBuf>,
}

/// A description of which something is open.
#[derive(Default)]
pub(super) struct Description {
    pub(super) compilation: Option<Compilation>,
    /// Of the last compilation that could read the files.
    pub(super) knowledge: Option<Knowledge>,
    /// Whether something has changed since it was given to be compiled.
    pub(super) stale: bool,
    /// The files that have messages in the editor.
    pub(super) marked: BTreeSet<PathBuf>,
}

/// All that the server keeps.
pub(super) struct State {
    pub(super) send: Box<dyn Fn(Message)>,
    /// By the one name of their file.
    pub(super) open: BTreeMap<PathBuf, Open>,
    /// By their `device.toml`.
    pub(super) descriptions: BTreeMap<PathBuf, Description>,
    pub(super) profiles: Profiles,
}

impl State {
    /// Finds the description of a file, if it has none yet.
    pub(super) fn find_main(&mut self, name: &Path) {
        if self.profiles.has(name) {
            return;
        }
        let is_main = name.file_name().is_some_and(|file| file == MAIN_FILE);
        let overlay = self.overlay();
        let main = owner(&overlay, name).or_else(|| is_main.then(|| name.to_owned()));
        if let Some(main) = &main {
            self.descriptions.entry(main.clone()).or_default();
        }
        if let Some(open) = self.open.get_mut(name) {
            open.main = main;
        }
    }

    /// What is known of the description of a file is out of date.
    pub(super) fn changed(&mut self, name: &Path) {
        let main = self.open.get(name).and_then(|open| open.main.clone());
        if let Some(description) = main.and_then(|main| self.descriptions.get_mut(&main)) {
            description.stale = true;
        }
    }

    /// What is known of all descriptions is out of date.
    pub(super) fn all_stale(&mut self) {
        let names: Vec<PathBuf> =
            self.open.iter().filter(|(_, it)| it.main.is_none()).map(|(it, _)| it.clone()).collect();
        names.iter().for_each(|name| self.find_main(name));
        self.descriptions.values_mut().for_each(|description| description.stale = true);
    }

    /// A description to compile, as it is now.
    pub(super) fn job(&mut self, main: &Path) -> Job {
        if let Some(description) = self.descriptions.get_mut(main) {
            description.stale = false;
        }
        let versions = self.open.iter().map(|(name, open)| (name.clone(), open.version)).collect();
        Job { main: main.to_owned(), overlay: self.overlay(), versions }
    }

    pub(super) fn overlay(&self) -> Overlay {
        Overlay(self.open.iter().map(|(name, open)| (name.clone(), open.text.text.clone())).collect())
    }

    /// The address of a file, as the editor has it if it is open.
    pub(super) fn uri(&self, name: &Path) -> String {
        self.open.get(name).map_or_else(|| uri::uri(name), |open| open.uri.clone())
    }

    pub(super) fn notify(&self, method: &str, params: serde_json::Value) {
        (self.send)(Message::Notification(Notification { method: method.to_owned(), params }));
    }
}

/// The one name of a file that an editor names.
pub(super) fn name(uri: &str) -> Option<PathBuf> {
    let path = uri::path(uri)?;
    Some(Disk.canonical(&path).unwrap_or(path))
}
