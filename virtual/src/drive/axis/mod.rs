//! An axis: its mode of operation, what it does in that, and what it shows.

mod homing;
mod lag;
mod model;
mod motion;
mod plant;
mod probe;
mod ramp;
mod roles;
mod scale;
mod set_points;
mod status;

use devc_runtime::cia402::{Events, Machine, ModeStep, ModeSwitch, Refusal, Running, State};

pub(super) use self::model::AxisModel;
use self::motion::{Cycle, Motion};
use self::probe::Probe;
pub use self::status::AxisStatus;
use super::dictionary::Values;

/// Codes of CiA 402 (IEC 61800-7-201, error codes).
pub(super) const PARAMETER_ERROR: u16 = 0x6320;
pub(super) const FOLLOWING_ERROR: u16 = 0x8611;

/// An axis as it runs.
#[derive(Debug, Clone)]
pub(super) struct Axis {
    model: &'static AxisModel,
    machine: &'static Machine,
    modes: ModeSwitch,
    motion: Motion,
    probes: [Probe; 2],
    state: State,
    controlword: u16,
    /// The cause of a fault, until the reaction to it has begun.
    fault: Option<u16>,
    /// What 0x603F shows.
    pub(super) error: u16,
}

/// What an axis has to do in a cycle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Order {
    /// The state of its machine.
    pub(super) state: State,
    pub(super) controlword: u16,
    /// The mode that is asked for.
    pub(super) mode: i8,
    /// Seconds since the last.
    pub(super) time: f64,
}

impl Axis {
    pub(super) fn new(model: &'static AxisModel, machine: &'static Machine) -> Self {
        Self {
            model,
            machine,
            modes: ModeSwitch::new(&machine.modes),
            motion: Motion::default(),
            probes: Default::default(),
            state: State::NotReadyToSwitchOn,
            controlword: 0,
            fault: None,
            error: 0,
        }
    }

    /// The controlword, and the mode that is asked for.
    pub(super) fn asked(&self, values: &Values) -> (u16, i8) {
        let roles = &self.model.roles;
        let word = roles.controlword.map_or(0, |number| number.get(values));
        let mode = roles.mode.map_or(0, |number| number.get(values));
        (u16::try_from(word & 0xFFFF).unwrap_or(0), i8::try_from(mode).unwrap_or(0))
    }

    /// What holds on it besides its commands.
    pub(super) fn events(&self, values: &Values) -> Events {
        let is_over = self.motion.is_over();
        // CiA 402, quick stop option code: 5 to 8 stay in quick stop active
        let option = self.model.roles.quick_stop_option.map_or(0, |number| number.get(values));
        let when = |is_so, event| if is_so { event } else { Events::NONE };
        Events::INITIALISED
            | when(self.fault.is_some(), Events::FAULT)
            | when(is_over, Events::FAULT_REACTION_OVER)
            | when(is_over && !(5..=8).contains(&option), Events::QUICK_STOP_OVER)
    }

    /// There is the cause of a fault.
    pub(super) fn fail(&mut self, code: u16) {
        self.fault = self.fault.or(Some(code));
    }

    /// The reaction to a fault begins: its cause, if it was on this axis.
    pub(super) fn react(&mut self) -> Option<u16> {
        self.fault.take()
    }

    /// Holds it fast, or lets it go.
    pub(super) fn hold(&mut self, is_held: bool) {
        self.motion.plant.is_held = is_held;
    }

    /// The signal of a touch probe, 0 or 1, has a level.
    pub(super) fn signal(&mut self, probe: usize, is_high: bool) {
        if let Some(probe) = self.probes.get_mut(probe) {
            probe.signal(is_high, self.motion.plant.position);
        }
    }

    /// Whether the drive acts on its set values, or stops by itself.
    pub(super) fn is_active(&self) -> bool {
        matches!(self.state, State::OperationEnabled | State::QuickStopActive)
    }

    /// One cycle after that of the machine.
    pub(super) fn cycle(&mut self, values: &Values, order: Order) {
        let was = (self.state, self.modes.display());
        self.state = order.state;
        self.change_mode(order);
        let mode = self.model.mode(self.modes.display());
        match (order.state, mode) {
            (State::OperationEnabled, Some(mode)) => {
                if was != (self.state, self.modes.display()) {
                    // an edge counts from the word before
                    self.motion.enter(self.controlword, self.model);
                }
                let Order { controlword, time, .. } = order;
                let cycle = Cycle { model: self.model, mode, values, controlword, time };
                self.motion.follow(&cycle);
                if self.motion.has_lost_track(&cycle) {
                    self.fail(FOLLOWING_ERROR);
                }
            }
            (State::OperationEnabled | State::QuickStopActive | State::FaultReactionActive, _) => {
                self.motion.brake(order.time);
            }
            _ => self.motion.stand(),
        }
        self.controlword = order.controlword;
        let function = self.model.roles.probe_function.map_or(0, |number| number.get(values));
        for (probe, function) in self.probes.iter_mut().zip(function.to_le_bytes()) {
            probe.arm(function);
        }
    }

    fn change_mode(&mut self, order: Order) {
        let running = match (self.motion.is_over(), self.machine.modes.refusal) {
            (true, _) => Running::Over,
            (false, Refusal::Ignored) => Running::Busy,
            (false, Refusal::Fault) => Running::Failed,
        };
        let modes = &self.machine.modes;
        if !modes.are_selectable_in(order.state) && modes.has(0) {
            // a mode that can be chosen in some states only ends with them
            self.modes.clear();
        }
        if let ModeStep::Failed { .. } = self.modes.cycle(order.mode, order.state, running) {
            self.fail(PARAMETER_ERROR);
        }
    }
}
