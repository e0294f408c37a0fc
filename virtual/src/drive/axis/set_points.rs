//! Profile position mode on the side of the drive (CiA 402, profile position mode, set-points).

use super::ramp::{Dynamics, Ramp};

const NEW_SET_POINT: u16 = 1 << 4;
const CHANGE_IMMEDIATELY: u16 = 1 << 5;
const RELATIVE: u16 = 1 << 6;

/// Takes set-points, one while another is on its way, and travels to them.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SetPoints {
    ramp: Ramp,
    target: f64,
    next: Option<f64>,
    is_given: bool,
    is_travelling: bool,
}

impl SetPoints {
    /// Standing at a position, with the controlword that was received last.
    pub(super) const fn at(position: f64, controlword: u16) -> Self {
        let is_given = controlword & NEW_SET_POINT != 0;
        Self { ramp: Ramp::at(position), target: position, next: None, is_given, is_travelling: false }
    }

    /// One cycle: what the master gives, and where the axis should be.
    pub(super) fn cycle(&mut self, controlword: u16, offered: f64, dynamics: Dynamics, time: f64) -> f64 {
        let is_given = controlword & NEW_SET_POINT != 0;
        let was_given = std::mem::replace(&mut self.is_given, is_given);
        let is_new = is_given && !was_given;
        if is_new && self.next.is_none() {
            self.take(controlword, offered);
        }
        if let Some(next) = self.next.filter(|_| !self.is_travelling) {
            (self.target, self.next, self.is_travelling) = (next, None, true);
        }
        self.ramp.approach(self.target, dynamics, time);
        self.ramp.position
    }

    fn take(&mut self, controlword: u16, offered: f64) {
        let target = if controlword & RELATIVE != 0 { self.target + offered } else { offered };
        if controlword & CHANGE_IMMEDIATELY != 0 || !self.is_travelling {
            (self.target, self.is_travelling) = (target, true);
        } else {
            self.next = Some(target);
        }
    }

    /// One cycle with halt: the drive slows down, and goes on when halt ends.
    pub(super) fn halt(&mut self, dynamics: Dynamics, time: f64) -> f64 {
        self.ramp.accelerate(0.0, dynamics, time);
        self.ramp.position
    }

    /// Whether the last set-point is taken and a further one cannot be given yet (statusword, bit 12).
    pub(super) const fn is_acknowledged(&self) -> bool {
        self.is_given || self.next.is_some()
    }

    /// Tells where the axis is, and whether the target is reached with that (statusword, bit 10).
    pub(super) fn has_arrived(&mut self, position: f64) -> bool {
        if self.is_travelling && self.ramp.position == self.target && (position - self.target).abs() < 0.5 {
            self.is_travelling = false;
        }
        !self.is_travelling && self.next.is_none()
    }
}
