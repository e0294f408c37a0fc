//! Ramps that a drive makes by itself.

/// How fast and how steep, in steps and seconds. A steepness of 0 is none: the velocity changes at once.
#[derive(Debug, Clone, Copy)]
pub(super) struct Dynamics {
    pub(super) velocity: f64,
    pub(super) acceleration: f64,
    pub(super) deceleration: f64,
}

/// A demand that moves: what a motion profile asks of the axis at present.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Ramp {
    pub(super) position: f64,
    pub(super) velocity: f64,
}

/// A value changed by no more than this, towards its aim.
pub(super) fn limited(value: f64, aim: f64, most: f64) -> f64 {
    value + (aim - value).clamp(-most, most)
}

impl Ramp {
    /// Standing at a position.
    pub(super) const fn at(position: f64) -> Self {
        Self { position, velocity: 0.0 }
    }

    /// Goes on towards a velocity.
    pub(super) fn accelerate(&mut self, velocity: f64, dynamics: Dynamics, time: f64) {
        let is_faster = velocity.abs() > self.velocity.abs();
        let steepness = if is_faster { dynamics.acceleration } else { dynamics.deceleration };
        let most = if steepness > 0.0 { steepness * time } else { f64::INFINITY };
        self.velocity = limited(self.velocity, velocity, most);
        self.position += self.velocity * time;
    }

    /// Goes on towards a position, so as to stop there.
    pub(super) fn approach(&mut self, position: f64, dynamics: Dynamics, time: f64) {
        let left = position - self.position;
        let stopping = if dynamics.deceleration > 0.0 {
            (2.0 * dynamics.deceleration * left.abs()).sqrt()
        } else {
            f64::INFINITY
        };
        let velocity = dynamics.velocity.min(stopping).copysign(left);
        self.accelerate(velocity, dynamics, time);
        let is_over = left == 0.0 || (position - self.position) * left <= 0.0;
        if is_over || (position - self.position).abs() < 0.5 {
            *self = Self::at(position);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Dynamics, Ramp};

    #[test]
    fn a_profile_takes_the_time_of_a_trapezoid_and_stops_where_it_should() {
        // up to 1000 in 0.1 s, 0.9 s at that, and down in 0.2 s: 50 + 900 + 100
        let dynamics = Dynamics { velocity: 1000.0, acceleration: 10_000.0, deceleration: 5_000.0 };
        for target in [1050.0, -1050.0] {
            let (mut ramp, mut fastest, mut time) = (Ramp::default(), 0.0_f64, 0);
            while ramp.position != target {
                ramp.approach(target, dynamics, 0.001);
                fastest = fastest.max(ramp.velocity.abs());
                time += 1;
                assert!(time < 1300, "{ramp:?}");
            }
            // without the last half step, which takes sqrt(2 × 0.5 / 5000) s
            assert!((1180..1205).contains(&time), "{time} ms");
            assert_eq!((fastest, ramp.velocity), (1000.0, 0.0));
        }
    }
}
