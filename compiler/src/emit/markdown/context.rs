//! What all chapters share: the device, and how its parts are named and linked.

mod axes;
mod parameters;
mod pictures;
mod prose;
mod said;
mod value;

use std::collections::BTreeSet;
use std::rc::Rc;

pub(super) use said::{assumption_id, erratum_id, once};

use self::parameters::Places;
use super::holds::Form;
use super::inline::{code, fragment, link, small, text};
use crate::model::{Address, Device, Entry, ErrorCode, Index, Mode, Object, Pdo, Source};

/// A device to be printed.
#[derive(Debug)]
pub(super) struct Context<'a> {
    /// The device.
    pub(super) device: &'a Device,
    /// All devices in the same document.
    members: &'a [Context<'a>],
    /// Whether to show how sure facts are: what no source states, and what contradicts itself.
    pub(super) editorial: bool,
    /// What the document is.
    pub(super) form: Form,
    /// The anchors of the vendor's parameters, by name.
    places: Rc<Places<'a>>,
    /// Those of all devices in the same document.
    shared: Rc<Places<'a>>,
    /// What the names of parameters begin with.
    initials: Rc<BTreeSet<char>>,
}

impl<'a> Context<'a> {
    /// A device in a document of its own.
    pub(super) fn new(device: &'a Device, editorial: bool, form: Form) -> Self {
        let (places, shared, initials) = <_>::default();
        let context = Self { device, members: &[], editorial, form, places, shared, initials };
        let places = context.places();
        Self { initials: parameters::initials(&places).into(), places: places.into(), ..context }
    }

    /// Each device in a document with others of its family: what it names but lacks may be described for them.
    pub(super) fn among(members: &'a [Context<'a>]) -> impl Iterator<Item = Self> {
        let shared = Rc::new(parameters::shared(members));
        let initials = Rc::new(parameters::initials(&shared));
        members.iter().map(move |own| Self {
            members,
            places: Rc::clone(&own.places),
            shared: Rc::clone(&shared),
            initials: Rc::clone(&initials),
            ..*own
        })
    }

    /// The anchor of an object; that of the first axis stands for all.
    pub(super) fn object_id(&self, object: &Object) -> String {
        format!("obj-{:04x}", object.leading.0)
    }

    /// The anchor of a PDO; that of the first axis stands for all.
    pub(super) fn pdo_id(&self, pdo: &Pdo) -> String {
        format!("pdo-{:04x}", pdo.leading.0)
    }

    /// The anchor of a word.
    pub(super) fn word_id(&self, id: &str) -> String {
        fragment(format!("word-{id}"))
    }

    /// The anchor of an error code.
    pub(super) fn error_id(&self, error: &ErrorCode) -> String {
        format!("error-{:04x}", error.code)
    }

    /// The anchor of a mode.
    pub(super) fn mode_id(&self, code: i16) -> String {
        format!("mode-{code}")
    }

    /// An index, linked to the PDO or the object that it names.
    pub(super) fn index(&self, index: Index) -> String {
        self.linked(index, &code(index))
    }

    /// A label, linked to what the index names, in this device or else in another of the document.
    fn linked(&self, index: Index, label: &str) -> String {
        let own = self.anchor(index);
        let others = || self.members.iter().find_map(|member| member.anchor(index));
        own.or_else(others).map_or_else(|| label.into(), |anchor| link(label, anchor))
    }

    /// The anchor of what an index names: a PDO, an object, or an error code.
    fn anchor(&self, index: Index) -> Option<String> {
        let device = self.device;
        let pdo = device.pdo(index).map(|pdo| self.pdo_id(pdo));
        let object = || device.object(index).map(|object| self.object_id(object));
        let error =
            || device.errors.iter().find(|error| error.code == index.0).map(|error| self.error_id(error));
        pdo.or_else(object).or_else(error)
    }

    /// An address, linked to its object. Subindex 0 stands for the object.
    pub(super) fn address(&self, address: Address) -> String {
        let label = if address.subindex == 0 { code(address.index) } else { code(address) };
        self.linked(address.index, &label)
    }

    /// An address with its subindex, linked to its object.
    pub(super) fn exact(&self, address: Address) -> String {
        self.linked(address.index, &code(address))
    }

    /// An address with the name of what it names.
    pub(super) fn named(&self, address: Address) -> String {
        match self.name(address) {
            Some(name) => format!("{} {}", self.address(address), text(&name)),
            None => self.address(address),
        }
    }

    /// The name of an entry; that of the object for subindex 0.
    pub(super) fn name(&self, address: Address) -> Option<String> {
        let object = self.device.object(address.index)?;
        if address.subindex == 0 {
            return Some(object.name.clone());
        }
        object.entry(address.subindex).map(|entry| format!("{}: {}", object.name, entry.name))
    }

    /// A mode by name, linked.
    pub(super) fn mode(&self, code: i16) -> String {
        match self.device.modes.iter().find(|mode| mode.code == code) {
            Some(mode) => link(mode_label(mode), self.mode_id(code)),
            None => code.to_string(),
        }
    }

    /// The code of a mode, linked.
    pub(super) fn mode_code(&self, code: i16) -> String {
        let known = self.device.modes.iter().any(|mode| mode.code == code);
        if known { link(code, self.mode_id(code)) } else { code.to_string() }
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

    /// Where a fact is from, in small print.
    pub(super) fn source(&self, source: Option<&Source>) -> String {
        small(&self.place(source))
    }

    /// Where a fact is from: the place, with the document unless it is the main one.
    pub(super) fn place(&self, source: Option<&Source>) -> String {
        let Some(source) = source else { return String::new() };
        let main = self.device.documents.first().map(|document| document.id.as_str());
        match source.document.as_deref().filter(|id| Some(*id) != main) {
            Some(id) => {
                format!("{}, {}", link(text(id), format!("doc-{id}")), self.prose(&source.place))
            }
            None => self.prose(&source.place),
        }
    }

    /// Where a fact is from, in a line of small print.
    pub(super) fn source_line(&self, source: Option<&Source>) -> String {
        let place = self.place(source);
        if place.is_empty() { place } else { small(&format!("Source: {place}")) }
    }

    /// The unit of an entry, linked; of all axes, if it stands for them. Where members count in different
    /// units, the quantity stands for them.
    pub(super) fn unit(&self, entry: &Entry) -> String {
        let Some(id) = entry.unit.as_deref() else { return String::new() };
        let symbols = symbols(self.device, id);
        let others = self.members.iter().filter_map(|member| member.device.unit(id));
        let label = match self.members.iter().all(|member| symbols == self::symbols(member.device, id)) {
            _ if symbols.is_empty() => id.to_owned(),
            true => symbols.join(", "),
            false => others.map(|unit| unit.quantity.as_str()).next().unwrap_or(id).to_owned(),
        };
        link(text(&label), format!("unit-{id}"))
    }
}

/// What a unit is called on the axes, each name once.
fn symbols<'d>(device: &'d Device, id: &str) -> Vec<&'d str> {
    let mut symbols: Vec<&str> = Vec::new();
    for on_axis in device.unit(id).into_iter().flat_map(|unit| &unit.axes) {
        if !symbols.contains(&on_axis.symbol.as_str()) {
            symbols.push(&on_axis.symbol);
        }
    }
    symbols
}

/// Whether an object is one value.
pub(super) fn is_single(object: &Object) -> bool {
    object.kind == crate::model::Kind::Var
}

/// How a mode is called in running text.
pub(super) fn mode_label(mode: &Mode) -> String {
    format!("{} {}", mode.code, text(&mode.name))
}
