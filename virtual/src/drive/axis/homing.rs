//! Homing mode on the side of the drive (CiA 402, homing mode).

use devc::model::Way;
use devc_runtime::cia402::HomingBits;

use super::plant::Plant;

/// How long the axis looks for its reference, in seconds, and how fast, in steps a second, where no object says. There is
/// no switch in a description, nor a place for it: the axis finds what it looks for after a while.
const SEARCH: f64 = 0.05;
pub(super) const SPEED: f64 = 1000.0;

/// A reference run.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Homing {
    /// The start bit, as it was received last.
    is_given: bool,
    /// Seconds until the reference is found, while it is looked for.
    left: Option<f64>,
    is_attained: bool,
    has_failed: bool,
}

/// What a reference run is done by.
#[derive(Debug, Clone, Copy)]
pub(super) struct Run {
    /// The direction of the method; none inside if it does not move, and none at all if the device has no such method.
    pub(super) method: Option<Option<Way>>,
    /// Steps a second; 0 if no object says.
    pub(super) speed: f64,
    /// The position of the reference.
    pub(super) offset: f64,
}

impl Homing {
    /// The mode begins, with the start bit as it is.
    pub(super) const fn enter(&mut self, is_given: bool) {
        (self.is_given, self.left) = (is_given, None);
    }

    /// One cycle with the start bit; its rising edge starts the run, and the run ends when it falls.
    pub(super) fn cycle(&mut self, is_given: bool, run: Run, plant: &mut Plant, time: f64) {
        let was_given = std::mem::replace(&mut self.is_given, is_given);
        let is_new = is_given && !was_given;
        if is_new {
            (self.is_attained, self.has_failed) = (false, run.method.is_none());
            self.left = run.method.map(|_| SEARCH);
            return plant.brake(time);
        }
        let Some(left) = self.left.filter(|_| is_given) else {
            self.left = None;
            return plant.brake(time);
        };
        if left > time {
            let direction = match run.method.flatten() {
                None => 0.0,
                Some(Way::Positive) => 1.0,
                Some(Way::Negative) => -1.0,
            };
            plant.run(direction * if run.speed > 0.0 { run.speed } else { SPEED }, time);
            self.left = Some(left - time);
            return;
        }
        *plant = Plant { position: run.offset, velocity: 0.0, ..*plant };
        (self.left, self.is_attained) = (None, true);
    }

    /// Whether it looks for the reference.
    pub(super) const fn is_running(&self) -> bool {
        self.left.is_some()
    }

    /// Stops, without a reference.
    pub(super) const fn abort(&mut self) {
        self.left = None;
    }

    /// The bits of the statusword, of the mode.
    pub(super) fn bits(&self, bits: HomingBits, plant: &Plant) -> u16 {
        let is_over = !self.is_running() && plant.is_at_rest();
        let reached = if is_over { bits.reached } else { 0 };
        reached | self.lasting(bits)
    }

    /// Those that a drive may show in every mode.
    pub(super) const fn lasting(&self, bits: HomingBits) -> u16 {
        let attained = if self.is_attained { bits.attained } else { 0 };
        attained | if self.has_failed { bits.error } else { 0 }
    }
}
