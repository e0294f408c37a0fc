//! The firmware of a drive, made from its description while the program runs.
//!
//! It is put together of the pieces that firmware with generated code uses: the dictionary with its SDO server and mailbox,
//! the EtherCAT state machine, process data as it is mapped at present, and the drives of CiA 402. What generated code has
//! as constants is made from the model, in [`Model`]; and behind each axis there is something that moves.
//!
//! ```
//! use std::path::Path;
//! use std::time::Duration;
//!
//! use devc::source::Disk;
//! use devc_runtime::cia402::State;
//! use devc_virtual::Firmware;
//! use devc_virtual::drive::{Drive, Model};
//!
//! let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../devices/c887");
//! let family = devc::compile(&Disk, &folder).family.expect("the description has no errors");
//! let mut drive = Drive::new(Model::new(&family.members[0]));
//! drive.step(Duration::from_millis(1));
//! drive.step(Duration::from_millis(1));
//! assert_eq!(drive.axes()[5].name, "W");
//! assert_eq!(drive.axes()[5].state, State::SwitchOnDisabled);
//! ```

mod application;
mod areas;
mod axis;
mod clocks;
mod control;
mod dictionary;
mod effects;
mod errors;
mod files;
mod firmware;
mod forever;
mod machine;
mod model;
mod stored;

use devc_runtime::cia402::{Cause, Step};
use devc_runtime::coe::Mailbox;
use devc_runtime::esm::{AlState, StateMachine};
use devc_runtime::object::Address;
use devc_runtime::sdo::{Server, Values as _};

use self::axis::{Axis, Order, PARAMETER_ERROR};
use self::control::Control;
use self::dictionary::Number;
use self::effects::Effects;
use self::errors::Errors;
use self::model::Facts;

pub use self::axis::AxisStatus;
pub use self::dictionary::Values;
pub use self::model::Model;
pub use self::stored::Stored;
use crate::{Clocks, Event};

/// Bytes of the longest value that a master may write in segments.
pub const LONGEST_DOWNLOAD: usize = 2048;

/// How many sync managers a controller can have (ETG.1000.4).
const MANAGERS: usize = 16;

/// The code of a drive whose master is gone, if the description has it (IEC 61800-7-201, error codes), else the first.
const MASTER_LOST: [u16; 2] = [0x8100, 0x7500];

/// A drive: its EtherCAT state, mailbox, dictionary and axes.
#[derive(Debug, Clone)]
pub struct Drive {
    facts: &'static Facts,
    mailbox: Mailbox<Values, Effects, LONGEST_DOWNLOAD>,
    states: StateMachine,
    control: Control,
    axes: Vec<Axis>,
    errors: Errors,
    /// Outputs that came in Safe-Operational.
    outputs: Option<Vec<u8>>,
    /// What a master has set of the clocks.
    clocks: Clocks,
    /// Values that outlast a power cycle.
    stored: Stored,
    /// What is to be told.
    events: Vec<Event>,
}

impl Drive {
    /// A drive that has just been switched on, in Init.
    pub fn new(model: Model) -> Self {
        Self::with_stored(model, Stored::new())
    }

    /// The same, with what a master has stored in it before.
    pub fn with_stored(model: Model, stored: Stored) -> Self {
        let facts = model.facts();
        let mut values = model.values();
        facts.parameters.load(&stored, &mut values);
        let server = Server::new(values, Effects::new(&facts.triggers));
        Self {
            facts,
            mailbox: match model.names() {
                Some(names) => Mailbox::with_information(server, names),
                None => Mailbox::new(server),
            },
            states: StateMachine::new(facts.areas),
            control: Control::new(facts.machine, facts.axes.len(), facts.is_coupled),
            axes: facts.axes.iter().map(|axis| Axis::new(axis, facts.machine)).collect(),
            errors: Errors::default(),
            outputs: None,
            clocks: Clocks::default(),
            stored,
            events: Vec::new(),
        }
    }

    /// What a master has stored in it (CiA 301, 0x1010): it stays when the power is gone.
    pub const fn stored(&self) -> &Stored {
        &self.stored
    }

    /// Switched off and on again.
    pub fn power_cycle(&mut self) {
        *self = Self::with_stored(Model::of(self.facts), std::mem::take(&mut self.stored));
    }

    /// How the axes are at present, in their order.
    pub fn axes(&self) -> Vec<AxisStatus> {
        self.axes.iter().map(Axis::status).collect()
    }

    /// Provokes a fault on an axis, with an error code of 0x603F. Its cause is gone when the drive has reacted to it.
    pub fn fault(&mut self, axis: usize, code: u16) {
        if let Some(axis) = self.axes.get_mut(axis) {
            axis.fail(code);
        }
    }

    /// Holds an axis fast, or lets it go: it cannot follow, so that a following error comes.
    pub fn hold(&mut self, axis: usize, is_held: bool) {
        if let Some(axis) = self.axes.get_mut(axis) {
            axis.hold(is_held);
        }
    }

    /// The signal of a touch probe of an axis, 0 or 1, has a level from now on.
    pub fn signal(&mut self, axis: usize, probe: usize, is_high: bool) {
        if let Some(axis) = self.axes.get_mut(axis) {
            axis.signal(probe, is_high);
        }
    }

    /// The present value of an entry that is a whole number and can change.
    pub fn read(&self, address: Address) -> Option<i64> {
        let values = &self.mailbox.server.values;
        Number::find(values.table(), address).map(|number| number.get(values))
    }

    /// One cycle of the axes: machines, then modes and movement, then what they show.
    fn cycle(&mut self, time: f64) {
        let values = &self.mailbox.server.values;
        let asked: Vec<(u16, i8)> = self.axes.iter().map(|axis| axis.asked(values)).collect();
        let words = self.axes.iter().zip(&asked);
        let words: Vec<_> = words.map(|(axis, (word, _))| (*word, axis.events(values))).collect();
        for (axis, step) in self.control.cycle(&words) {
            self.made(axis, step);
        }
        let values = &self.mailbox.server.values;
        let first = asked.first().copied().unwrap_or_default();
        for (number, (axis, own)) in self.axes.iter_mut().zip(asked).enumerate() {
            let (controlword, mode) = if self.facts.is_coupled { first } else { own };
            axis.cycle(values, Order { state: self.control.state(number), controlword, mode, time });
        }
        self.show();
    }

    fn show(&mut self) {
        let values = &mut self.mailbox.server.values;
        let is_operational = self.states.state() == AlState::Operational;
        for (number, axis) in self.axes.iter_mut().enumerate() {
            let statusword = self.control.statusword(number, axis.bits(is_operational));
            axis.show(statusword, values);
        }
        if let Some(register) = self.facts.error_register {
            register.set(values, self.errors.register.into());
        }
    }

    /// What a transition of an axis brings with it: a fault is told, and so is its end.
    fn made(&mut self, axis: usize, step: Step) {
        let Some(of) = self.axes.get_mut(axis) else { return };
        match step.number {
            13 => {
                let refused =
                    matches!(step.cause, Cause::Refused { .. }) && (axis == 0 || !self.facts.is_coupled);
                let code = of.react().or(refused.then_some(PARAMETER_ERROR));
                if let Some(code) = code {
                    of.error = code;
                    self.errors.raise(code, self.facts);
                }
            }
            15 => {
                of.error = 0;
                let is_last = axis.saturating_add(1) == self.axes.len() || !self.facts.is_coupled;
                if is_last && self.axes.iter().all(|axis| axis.error == 0) {
                    self.errors.clear();
                }
            }
            _ => {}
        }
    }

    /// The master has left Operational, or is gone: axes that act on its set values take that for a fault.
    fn lose_master(&mut self) {
        let is_known =
            |code: &u16| self.facts.errors.iter().any(|(first, last, _)| (*first..=*last).contains(code));
        let [first, _] = MASTER_LOST;
        let code = MASTER_LOST.into_iter().find(is_known).unwrap_or(first);
        let count = if self.facts.is_coupled { 1 } else { self.axes.len() };
        for axis in self.axes.iter_mut().take(count).filter(|axis| axis.is_active()) {
            axis.fail(code);
        }
    }
}
