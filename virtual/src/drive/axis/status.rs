//! What an axis shows: its part of the statusword, and its actual values.

use devc_runtime::cia402::State;

use super::probe::Probe;
use super::{Axis, Values};

const TARGET_REACHED: u16 = 1 << 10;

/// An axis as it is at present.
#[derive(Debug, Clone, PartialEq)]
pub struct AxisStatus {
    /// Its name; empty if it is the only one and has none.
    pub name: String,
    /// The state of its machine.
    pub state: State,
    /// The mode of operation that is displayed.
    pub mode: i8,
    /// The name of the mode; empty if the description has none.
    pub mode_name: String,
    /// Where it is, in steps of its position.
    pub position: f64,
    /// How fast it is, in steps of its position a second.
    pub velocity: f64,
    /// The error code; 0 if there is none.
    pub error: u16,
    /// The unit of its position, and how much of it a step is, if the description says so.
    pub unit: Option<(String, f64)>,
}

impl Axis {
    /// What there is to say of it.
    pub(in crate::drive) fn status(&self) -> AxisStatus {
        let mode = self.modes.display();
        AxisStatus {
            name: self.model.name.clone(),
            state: self.state,
            mode,
            mode_name: self.model.mode(mode).map(|mode| mode.name.clone()).unwrap_or_default(),
            position: self.motion.plant.position,
            velocity: self.motion.plant.velocity,
            error: self.error,
            unit: self.model.unit.clone(),
        }
    }

    /// The bits of the statusword besides those of the state.
    pub(in crate::drive) fn bits(&self, is_operational: bool) -> u16 {
        let (model, motion) = (self.model, &self.motion);
        let has_power = matches!(
            self.state,
            State::SwitchedOn | State::OperationEnabled | State::QuickStopActive | State::FaultReactionActive
        );
        let general = [
            ("voltage-enabled", has_power),
            ("remote", is_operational),
            ("internal-limit-active", motion.is_limited),
        ];
        let general = general.iter().filter(|(_, is_so)| *is_so);
        let general = general.fold(0, |bits, (id, _)| bits | model.status_bit(id));
        let mode = model.mode(self.modes.display());
        let of_mode = mode.map_or(0, |mode| match mode.code {
            6 => motion.homing.bits(model.homing_bits, &motion.plant),
            _ => motion.shown & (mode.status_bits | model.status_bit("target-reached") & TARGET_REACHED),
        });
        let lasting = motion.homing.lasting(model.homing_bits);
        let is_shown = |bit: u16| if model.is_general(bit) { bit } else { 0 };
        general
            | of_mode
            | is_shown(lasting & model.homing_bits.attained)
            | is_shown(lasting & model.homing_bits.error)
    }

    /// Writes what is shown.
    pub(in crate::drive) fn show(&mut self, statusword: u16, values: &mut Values) {
        let (roles, motion) = (&self.model.roles, &mut self.motion);
        if let Some((least, most)) = roles.position.first().map(|number| number.range()) {
            motion.plant.wrap((least as f64, most as f64));
        }
        let mode = self.model.mode(self.modes.display());
        let velocity = motion.plant.velocity / self.model.scales.velocity;
        let torque = motion.torque(mode, self.model);
        let shown = [
            (roles.statusword, i64::from(statusword)),
            (roles.mode_display, self.modes.display().into()),
            (roles.error_code, self.error.into()),
            (roles.velocity, rounded(velocity)),
            (roles.vl_velocity, rounded(velocity)),
            (roles.torque, rounded(torque)),
            (roles.following_error, rounded(motion.lag.error())),
        ];
        self.show_probes(values);
        let position = rounded(self.motion.plant.position);
        let positions = roles.position.iter().map(|number| (Some(*number), position));
        for (number, value) in shown.into_iter().chain(positions) {
            if let Some(number) = number {
                number.set(values, value);
            }
        }
    }
}

impl Axis {
    /// Writes what the touch probes have seen.
    fn show_probes(&self, values: &mut Values) {
        let (roles, scale) = (&self.model.roles, self.model.scales.probe);
        if let Some(number) = roles.probe_status {
            number.set(values, u16::from_le_bytes(self.probes.map(|probe| probe.status())).into());
        }
        let places = roles.probe_positions.iter().flatten().zip(roles.probe_counts.iter().flatten());
        let seen = self.probes.iter().flat_map(Probe::seen);
        for ((position, count), (at, times)) in places.zip(seen) {
            if let (Some(number), Some(at)) = (position, at) {
                number.set(values, rounded(at / scale));
            }
            if let Some(number) = count {
                number.set(values, times.into());
            }
        }
    }
}

/// The whole number that is nearest.
fn rounded(value: f64) -> i64 {
    value.round() as i64
}
