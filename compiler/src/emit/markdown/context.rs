//! What all chapters share: the device, and how its parts are named and linked.

mod axes;
mod prose;
mod value;

use super::inline::{code, link, text};
use crate::model::{Address, Device, Entry, Index, Mode, Object, Pdo, Source};

/// A device to be printed.
#[derive(Debug)]
pub(super) struct Context<'a> {
    /// The device.
    pub(super) device: &'a Device,
    prefix: String,
}

impl<'a> Context<'a> {
    /// A device whose anchors begin with `prefix`, as other devices are in the same document.
    pub(super) fn new(device: &'a Device, prefix: String) -> Self {
        Self { device, prefix }
    }

    /// An anchor's name.
    pub(super) fn id(&self, id: &str) -> String {
        format!("{}{id}", self.prefix)
    }

    /// The anchor of an object; that of the first axis stands for all.
    pub(super) fn object_id(&self, object: &Object) -> String {
        self.id(&format!("obj-{:04x}", self.leading_object(object).0))
    }

    /// The anchor of a PDO; that of the first axis stands for all.
    pub(super) fn pdo_id(&self, pdo: &Pdo) -> String {
        self.id(&format!("pdo-{:04x}", self.leading_pdo(pdo).0))
    }

    /// The anchor of a word.
    pub(super) fn word_id(&self, id: &str) -> String {
        self.id(&format!("word-{id}"))
    }

    /// The anchor of a mode.
    pub(super) fn mode_id(&self, code: i16) -> String {
        self.id(&format!("mode-{code}"))
    }

    /// An index, linked to the PDO or the object that it names.
    pub(super) fn index(&self, index: Index) -> String {
        self.linked(index, &code(index))
    }

    fn linked(&self, index: Index, label: &str) -> String {
        if let Some(pdo) = self.device.pdo(index) {
            return link(label, self.pdo_id(pdo));
        }
        self.device.object(index).map_or_else(|| label.into(), |object| link(label, self.object_id(object)))
    }

    /// An address, linked to its object; the subindex only where there are several.
    pub(super) fn address(&self, address: Address) -> String {
        let single = self.device.object(address.index).is_none_or(is_single);
        let label = if single && address.subindex == 0 { code(address.index) } else { code(address) };
        self.linked(address.index, &label)
    }

    /// An address with the name of what it names.
    pub(super) fn named(&self, address: Address) -> String {
        match self.name(address) {
            Some(name) => format!("{} {}", self.address(address), text(&name)),
            None => self.address(address),
        }
    }

    /// The name of an entry; of the object alone where it has one value, or where all of it is meant.
    pub(super) fn name(&self, address: Address) -> Option<String> {
        let object = self.device.object(address.index)?;
        if address.subindex == 0 {
            return Some(object.name.clone());
        }
        object.entry(address.subindex).map(|entry| format!("{}: {}", object.name, entry.name))
    }

    /// An object or all of it: subindex 0 of a record stands for the record.
    pub(super) fn whole(&self, address: Address) -> String {
        if address.subindex == 0 { self.index_named(address.index) } else { self.named(address) }
    }

    fn index_named(&self, index: Index) -> String {
        let name =
            self.device.object(index).map_or(String::new(), |object| format!(" {}", text(&object.name)));
        format!("{}{name}", self.index(index))
    }

    /// A mode by name, linked.
    pub(super) fn mode(&self, code: i16) -> String {
        match self.device.modes.iter().find(|mode| mode.code == code) {
            Some(mode) => link(mode_label(mode), self.mode_id(code)),
            None => format!("mode {code}"),
        }
    }

    /// A state by name.
    pub(super) fn state(&self, id: &str) -> String {
        self.device
            .states
            .iter()
            .find(|state| state.id == id)
            .map_or_else(|| code(id), |state| text(&state.name))
    }

    /// The commands that set off a transition, by name.
    pub(super) fn commands(&self, transition: u8) -> impl Iterator<Item = &'a str> {
        let commands = self.device.commands.iter();
        commands
            .filter(move |command| command.transitions.contains(&transition))
            .map(|command| command.name.as_str())
    }

    /// Where a fact is from: the place, with the document unless it is the main one.
    pub(super) fn source(&self, source: Option<&Source>) -> String {
        let Some(source) = source else { return String::new() };
        let main = self.device.documents.first().map(|document| document.id.as_str());
        match source.document.as_deref().filter(|id| Some(*id) != main) {
            Some(id) => {
                format!("{}, {}", link(text(id), self.id(&format!("doc-{id}"))), self.prose(&source.place))
            }
            None => self.prose(&source.place),
        }
    }

    /// The unit of an entry as a symbol, with its scaling, linked.
    pub(super) fn unit(&self, entry: &Entry, axis: Option<u8>) -> String {
        let Some(id) = entry.unit.as_deref() else { return String::new() };
        let symbol =
            self.device.unit(id).and_then(|unit| unit.on(axis)).map_or(id, |unit| unit.symbol.as_str());
        link(text(symbol), self.id(&format!("unit-{id}")))
    }
}

/// Whether an object is one value.
pub(super) fn is_single(object: &Object) -> bool {
    object.kind == crate::model::Kind::Var
}

/// How a mode is called in running text.
pub(super) fn mode_label(mode: &Mode) -> String {
    format!("{} {}", mode.code, text(&mode.name))
}
