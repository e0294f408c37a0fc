//! What is moved: a position that follows what the drive wants with a little delay.

/// Times, in seconds, in which most of a step is done: of position, velocity and braking, and of what a torque does to the
/// velocity.
const POSITION: f64 = 0.001;
const VELOCITY: f64 = 0.005;
const BRAKE: f64 = 0.002;
const TORQUE: f64 = 0.05;

/// A mechanical axis, in steps of its position and seconds.
///
/// Each quantity goes to its aim as a first-order lag does: it gets there whatever the time between two steps is, and never
/// swings.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Plant {
    pub(super) position: f64,
    pub(super) velocity: f64,
    /// Held fast, by a hand or by dirt: it does not move.
    pub(super) is_held: bool,
}

/// What part of a step is done after a time.
fn share(time: f64, lag: f64) -> f64 {
    1.0 - (-time / lag).exp()
}

/// The value nearer to its aim; at it, if less than half a step is left.
fn approach(value: f64, aim: f64, share: f64) -> f64 {
    let next = value + (aim - value) * share;
    if (aim - next).abs() < 0.5 { aim } else { next }
}

impl Plant {
    /// Under control of the position.
    pub(super) fn follow(&mut self, position: f64, time: f64) {
        if time <= 0.0 {
            return;
        }
        let next = if self.is_held {
            self.position
        } else {
            approach(self.position, position, share(time, POSITION))
        };
        self.velocity = (next - self.position) / time;
        self.position = next;
    }

    /// Under control of the velocity.
    pub(super) fn run(&mut self, velocity: f64, time: f64) {
        self.turn(velocity, share(time, VELOCITY), time);
    }

    /// Under a torque, that would hold this velocity against the friction.
    pub(super) fn push(&mut self, velocity: f64, time: f64) {
        self.turn(velocity, share(time, TORQUE), time);
    }

    /// To a halt.
    pub(super) fn brake(&mut self, time: f64) {
        self.turn(0.0, share(time, BRAKE), time);
    }

    /// Without power, and with the brake applied.
    pub(super) const fn stand(&mut self) {
        self.velocity = 0.0;
    }

    /// Whether it does not move.
    pub(super) fn is_at_rest(&self) -> bool {
        self.velocity == 0.0
    }

    fn turn(&mut self, velocity: f64, share: f64, time: f64) {
        self.velocity = if self.is_held { 0.0 } else { approach(self.velocity, velocity, share) };
        self.position += self.velocity * time;
    }

    /// Counts on from the other end, as a counter of positions does that has come to an end of its range.
    pub(super) fn wrap(&mut self, (least, most): (f64, f64)) {
        let turn = most - least + 1.0;
        if self.position > most || self.position < least {
            self.position = (self.position - least).rem_euclid(turn) + least;
        }
    }
}
