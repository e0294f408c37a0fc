//! What of a description the firmware of a drive runs on, made once.

use devc::model::{Device, Protocol};
use devc_runtime::cia402::{Coupling, Machine};
use devc_runtime::esm::Areas;
use devc_runtime::object::Address;
use devc_runtime::sdo::Names;

use super::axis::AxisModel;
use super::clocks::ClockModes;
use super::dictionary::{Number, Tables, Values};
use super::effects::Triggers;
use super::stored::Parameters;
use super::{areas, forever, machine};

const ERROR_REGISTER: Address = Address::new(0x1001, 0);

/// A device as its firmware has it: tables, state machine, and what each axis reads and writes.
///
/// It is made once for each device, from one that no rule of devc objects to, and then copied: what is behind it lasts as
/// long as the program, as constants do in a device.
#[derive(Debug, Clone, Copy)]
pub struct Model(&'static Facts);

/// The facts behind a model.
#[derive(Debug)]
pub(super) struct Facts {
    pub(super) tables: &'static Tables,
    pub(super) machine: &'static Machine,
    pub(super) areas: Areas,
    /// The protocols of the mailbox; CoE where nothing is said of it.
    protocols: Vec<Protocol>,
    pub(super) axes: Vec<AxisModel>,
    /// Whether the axes have one state, and the first commands all.
    pub(super) is_coupled: bool,
    /// 0x1001, the error register.
    pub(super) error_register: Option<Number>,
    /// Error codes with the error register that comes with each, and the last of a range.
    pub(super) errors: Vec<(u16, u16, Option<u8>)>,
    pub(super) clocks: ClockModes,
    pub(super) triggers: Triggers,
    /// What 0x1010 stores.
    pub(super) parameters: Parameters,
}

impl Facts {
    /// Whether the description names a protocol of the mailbox.
    pub(super) fn speaks(&self, protocol: Protocol) -> bool {
        self.protocols.contains(&protocol)
    }
}

impl Model {
    /// Makes the model of a device.
    pub fn new(device: &Device) -> Self {
        let (tables, machine) = (Tables::new(device), machine::machine(device));
        let axes = device.axes.iter().map(|axis| AxisModel::new(device, &tables.dictionary, axis));
        let errors = device.errors.iter().map(|error| (error.code, error.last, error.register));
        Self(forever::value(Facts {
            tables,
            machine,
            areas: areas::areas(device),
            protocols: device.mailbox.as_ref().map_or_else(|| vec![Protocol::Coe], |it| it.protocols.clone()),
            axes: axes.collect(),
            is_coupled: machine.transitions.iter().any(|one| one.coupling != Coupling::Independent),
            error_register: Number::find(&tables.dictionary, ERROR_REGISTER),
            errors: errors.collect(),
            clocks: ClockModes::new(device),
            triggers: Triggers::new(device, &tables.dictionary),
            parameters: Parameters::new(device, &tables.dictionary),
        }))
    }

    /// The values of its dictionary after start-up.
    pub fn values(self) -> Values {
        Values::new(self.0.tables)
    }

    /// The names of its objects and entries, if it tells them.
    pub fn names(self) -> Option<&'static Names> {
        self.0.tables.names
    }

    /// Its state machine.
    pub fn machine(self) -> &'static Machine {
        self.0.machine
    }

    pub(super) const fn of(facts: &'static Facts) -> Self {
        Self(facts)
    }

    pub(super) fn facts(self) -> &'static Facts {
        self.0
    }
}
