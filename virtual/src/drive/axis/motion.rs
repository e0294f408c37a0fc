//! What an axis does in its mode of operation.

use super::homing::{Homing, Run, SPEED};
use super::lag::{Lag, Window};
use super::model::{AxisModel, ModeModel};
use super::plant::Plant;
use super::ramp::{Dynamics, Ramp, limited};
use super::set_points::SetPoints;
use crate::drive::dictionary::{Number, Values};

const HALT: u16 = 1 << 8;
const INTERPOLATE: u16 = 1 << 4;
/// Enable, unlock and reference ramp of velocity mode.
const RAMP: [u16; 3] = [1 << 4, 1 << 5, 1 << 6];

/// The axis as it moves, from cycle to cycle.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Motion {
    pub(super) plant: Plant,
    pub(super) homing: Homing,
    pub(super) lag: Lag,
    set_points: SetPoints,
    ramp: Ramp,
    /// The torque that is applied, in steps of its object.
    torque: f64,
    /// Whether a set value lies beyond a limit.
    pub(super) is_limited: bool,
    /// Bits 10, 12 and 13 of the statusword, as the mode has them.
    pub(super) shown: u16,
    /// Whether the inputs are even or odd in number, for modes that show that they are updated.
    is_odd: bool,
}

/// What a cycle has to go by.
pub(super) struct Cycle<'a> {
    pub(super) model: &'a AxisModel,
    pub(super) mode: &'a ModeModel,
    pub(super) values: &'a Values,
    pub(super) controlword: u16,
    /// Seconds since the last.
    pub(super) time: f64,
}

const REACHED: u16 = 1 << 10;
const TWELVE: u16 = 1 << 12;
const THIRTEEN: u16 = 1 << 13;

fn when(is_so: bool, bits: u16) -> u16 {
    if is_so { bits } else { 0 }
}

impl Cycle<'_> {
    fn number(&self, number: Option<Number>) -> f64 {
        number.map_or(0.0, |number| number.get(self.values) as f64)
    }

    /// Whether bits are given that the mode knows.
    fn is_given(&self, bits: u16) -> bool {
        self.controlword & self.mode.control_bits & bits != 0
    }

    fn dynamics(&self) -> Dynamics {
        let (roles, scales) = (&self.model.roles, &self.model.scales);
        let acceleration = self.number(roles.profile_acceleration) * scales.acceleration;
        let deceleration = self.number(roles.profile_deceleration) * scales.acceleration;
        Dynamics {
            velocity: self.number(roles.profile_velocity) * scales.velocity,
            acceleration,
            deceleration: if deceleration > 0.0 { deceleration } else { acceleration },
        }
    }

    /// The following error that is allowed. A device that has no object for it shows any error of an axis that is held.
    fn window(&self, is_held: bool) -> Option<Window> {
        let Some(width) = self.model.roles.following_window else {
            return is_held.then_some(Window { width: 0.0, time: 0.0 });
        };
        let value = width.get(self.values);
        let is_on = value > 0 && i128::from(value) < width.range().1;
        let time = self.number(self.model.roles.following_time) / 1000.0;
        is_on.then_some(Window { width: value as f64, time })
    }

    /// A set position within the software limits, if there are any.
    fn within_limits(&self, position: f64) -> f64 {
        let limits =
            self.model.roles.position_limits.map(|limits| limits.map(|limit| self.number(Some(limit))));
        match limits {
            Some([least, most]) if least < most => position.clamp(least, most),
            _ => position,
        }
    }
}

impl Motion {
    /// The mode begins, or the drive is enabled in it: nothing of what was before goes on.
    pub(super) fn enter(&mut self, controlword: u16, model: &AxisModel) {
        self.set_points = SetPoints::at(self.plant.position, controlword);
        self.ramp = Ramp { position: self.plant.position, velocity: self.plant.velocity };
        self.homing.enter(controlword & model.homing_bits.start != 0);
        self.torque = 0.0;
    }

    /// A cycle in which the drive follows its mode.
    pub(super) fn follow(&mut self, cycle: &Cycle<'_>) {
        (self.is_limited, self.shown) = (false, 0);
        let is_halted = cycle.is_given(HALT);
        match cycle.mode.code {
            1 => self.profile_position(cycle, is_halted),
            2 => self.velocity_mode(cycle, is_halted),
            3 => self.profile_velocity(cycle, is_halted),
            4 => self.profile_torque(cycle, is_halted),
            6 => self.home(cycle, is_halted),
            7 => self.interpolated(cycle),
            8 => self.cyclic_position(cycle),
            9 => self.cyclic_velocity(cycle),
            10 => self.cyclic_torque(cycle),
            _ => self.jog(cycle),
        }
        if !matches!(cycle.mode.code, 1 | 7 | 8) {
            self.lag = Lag::default();
        }
    }

    /// A cycle in which the drive stops.
    pub(super) fn brake(&mut self, time: f64) {
        self.idle();
        self.plant.brake(time);
    }

    /// A cycle without power.
    pub(super) fn stand(&mut self) {
        self.idle();
        self.plant.stand();
    }

    fn idle(&mut self) {
        self.homing.abort();
        (self.lag, self.torque, self.is_limited, self.shown) = (Lag::default(), 0.0, false, 0);
    }

    /// The torque that is applied: what the mode asks for, or what the friction of the plant takes.
    pub(super) fn torque(&self, mode: Option<&ModeModel>, model: &AxisModel) -> f64 {
        match mode.map(|mode| mode.code) {
            Some(4 | 10) => self.torque,
            _ => self.plant.velocity / model.scales.velocity,
        }
    }

    /// Whether what the mode does is over, so that another may begin.
    pub(super) fn is_over(&self) -> bool {
        self.plant.is_at_rest() && !self.homing.is_running()
    }

    fn profile_position(&mut self, cycle: &Cycle<'_>, is_halted: bool) {
        let offered = cycle.number(cycle.mode.target_position);
        let demand = match is_halted {
            true => self.set_points.halt(cycle.dynamics(), cycle.time),
            false => self.set_points.cycle(cycle.controlword, offered, cycle.dynamics(), cycle.time),
        };
        self.go_to(demand, cycle);
        let has_arrived = self.set_points.has_arrived(self.plant.position);
        let is_reached = if is_halted { self.plant.is_at_rest() } else { has_arrived };
        self.shown = when(is_reached, REACHED)
            | when(self.set_points.is_acknowledged(), TWELVE)
            | when(self.is_lagging(cycle), THIRTEEN);
    }

    fn velocity_mode(&mut self, cycle: &Cycle<'_>, is_halted: bool) {
        let [enable, unlock, reference] =
            RAMP.map(|bit| cycle.mode.control_bits & bit == 0 || cycle.is_given(bit));
        let target = cycle.number(cycle.model.roles.vl_target_velocity) * cycle.model.scales.velocity;
        let aim = match (enable && reference && !is_halted, unlock) {
            (false, _) => 0.0,
            (true, false) => self.ramp.velocity,
            (true, true) => target,
        };
        self.ramp.velocity = aim;
        self.plant.run(aim, cycle.time);
    }

    fn profile_velocity(&mut self, cycle: &Cycle<'_>, is_halted: bool) {
        let target = cycle.number(cycle.model.roles.target_velocity) * cycle.model.scales.velocity;
        let aim = if is_halted { 0.0 } else { target };
        self.ramp.accelerate(aim, cycle.dynamics(), cycle.time);
        self.plant.run(self.ramp.velocity, cycle.time);
        self.shown = when(self.plant.velocity == aim, REACHED) | when(self.plant.is_at_rest(), TWELVE);
    }

    /// A mode of the vendor's: if it has bits to jog, the axis moves while one of them is set, as fast as in a profile.
    fn jog(&mut self, cycle: &Cycle<'_>) {
        let Some(bits) = cycle.mode.jog else { return self.plant.brake(cycle.time) };
        let way = match bits.map(|bit| cycle.is_given(bit)) {
            [true, false] => 1.0,
            [false, true] => -1.0,
            _ => 0.0,
        };
        let dynamics = cycle.dynamics();
        let speed = if dynamics.velocity > 0.0 { dynamics.velocity } else { SPEED };
        self.ramp.accelerate(way * speed, dynamics, cycle.time);
        self.plant.run(self.ramp.velocity, cycle.time);
    }

    fn profile_torque(&mut self, cycle: &Cycle<'_>, is_halted: bool) {
        let target = if is_halted { 0.0 } else { cycle.number(cycle.model.roles.target_torque) };
        let slope = cycle.number(cycle.model.roles.torque_slope);
        let most = if slope > 0.0 { slope * cycle.time } else { f64::INFINITY };
        self.push(limited(self.torque, target, most), cycle);
        self.shown = when(self.torque == target, REACHED);
    }

    fn home(&mut self, cycle: &Cycle<'_>, is_halted: bool) {
        let (model, bits) = (cycle.model, cycle.model.homing_bits);
        let number = model.roles.homing_method.map_or(0, |number| number.get(cycle.values));
        let known = model.homing_methods.iter().find(|(known, _)| i64::from(*known) == number);
        let run = Run {
            // a device whose methods nobody describes knows them all
            method: if model.homing_methods.is_empty() { Some(None) } else { known.map(|(_, way)| *way) },
            speed: cycle.number(model.roles.homing_speed) * model.scales.velocity,
            offset: cycle.number(model.roles.home_offset),
        };
        match is_halted {
            true => self.plant.brake(cycle.time),
            false => self.homing.cycle(cycle.controlword & bits.start != 0, run, &mut self.plant, cycle.time),
        }
        self.shown = self.homing.bits(bits, &self.plant);
    }

    fn interpolated(&mut self, cycle: &Cycle<'_>) {
        let is_active = cycle.mode.control_bits & INTERPOLATE == 0 || cycle.is_given(INTERPOLATE);
        match is_active {
            true => self.go_to(cycle.number(cycle.mode.target_position), cycle),
            false => self.plant.brake(cycle.time),
        }
        self.shown = when(is_active, TWELVE);
    }

    fn cyclic_position(&mut self, cycle: &Cycle<'_>) {
        self.go_to(cycle.number(cycle.mode.target_position), cycle);
        self.shown =
            self.cyclic(self.lag.error().abs() < 0.5, cycle) | when(self.is_lagging(cycle), THIRTEEN);
    }

    fn cyclic_velocity(&mut self, cycle: &Cycle<'_>) {
        let target = cycle.number(cycle.model.roles.target_velocity) * cycle.model.scales.velocity;
        self.plant.run(target, cycle.time);
        self.shown = self.cyclic(self.plant.velocity == target, cycle);
    }

    fn cyclic_torque(&mut self, cycle: &Cycle<'_>) {
        self.push(cycle.number(cycle.model.roles.target_torque), cycle);
        self.shown = self.cyclic(true, cycle);
    }

    /// What cyclic modes show: that the drive follows, and in bit 10 that the inputs are new, where the description gives the
    /// mode that bit (CiA 402, status toggle); else whether the axis is there.
    fn cyclic(&mut self, is_there: bool, cycle: &Cycle<'_>) -> u16 {
        self.is_odd = !self.is_odd;
        let is_toggle = cycle.mode.status_bits & REACHED != 0;
        TWELVE | when(if is_toggle { self.is_odd } else { is_there }, REACHED)
    }

    /// Under control of the position, within the limits.
    fn go_to(&mut self, position: f64, cycle: &Cycle<'_>) {
        let within = cycle.within_limits(position);
        self.is_limited = within != position;
        self.plant.follow(within, cycle.time);
        self.lag.cycle(within - self.plant.position, cycle.window(self.plant.is_held), cycle.time);
    }

    /// With a torque: as much of it as a step of the velocity takes makes the axis that fast.
    fn push(&mut self, torque: f64, cycle: &Cycle<'_>) {
        self.torque = torque;
        self.plant.push(torque * cycle.model.scales.velocity, cycle.time);
    }

    fn is_lagging(&self, cycle: &Cycle<'_>) -> bool {
        self.lag.is_too_large(cycle.window(self.plant.is_held))
    }

    /// Whether the following error is a fault: where an object says what is allowed.
    pub(super) fn has_lost_track(&self, cycle: &Cycle<'_>) -> bool {
        cycle.model.roles.following_window.is_some() && self.is_lagging(cycle)
    }
}
