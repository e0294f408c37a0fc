//! A touch probe: the position at the edges of a signal (CiA 402, touch probe).

/// The bits of 0x60B8 that belong to a probe, those of the first; the second has them in the high byte.
const ENABLE: u8 = 0x01;
const CONTINUOUS: u8 = 0x02;
const SOURCE: u8 = 0x0C;
const EDGES: [u8; 2] = [0x10, 0x20];
/// The source that is no signal but a mark of the encoder, which an axis that is none does not have.
const MARK: u8 = 0x04;

/// A rising and a falling edge: whether they were seen, where, and how often.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Probe {
    function: u8,
    is_high: bool,
    is_seen: [bool; 2],
    /// Where the last was, which stays when the probe is switched off.
    positions: [Option<f64>; 2],
    counts: [u16; 2],
}

impl Probe {
    /// Takes what a master asks for; one that is switched on begins anew.
    pub(super) fn arm(&mut self, function: u8) {
        if function & ENABLE == 0 || self.function & ENABLE == 0 {
            self.is_seen = [false; 2];
        }
        self.function = function;
    }

    /// The signal has a level, where the axis is now. Unless all are asked for, the first edge that is wanted counts.
    pub(super) fn signal(&mut self, is_high: bool, position: f64) {
        let was_high = std::mem::replace(&mut self.is_high, is_high);
        let edge = usize::from(!is_high);
        let is_wanted = EDGES.get(edge).is_some_and(|bit| self.function & bit != 0);
        let is_armed = self.function & ENABLE != 0 && self.function & SOURCE != MARK;
        let is_over = self.function & CONTINUOUS == 0 && self.is_seen.contains(&true);
        if was_high == is_high || !is_armed || !is_wanted || is_over {
            return;
        }
        let kept =
            self.is_seen.get_mut(edge).zip(self.positions.get_mut(edge)).zip(self.counts.get_mut(edge));
        if let Some(((is_seen, place), count)) = kept {
            (*is_seen, *place, *count) = (true, Some(position), count.wrapping_add(1));
        }
    }

    /// Its bits of 0x60B9, as the first has them.
    pub(super) fn status(&self) -> u8 {
        let [rising, falling] = self.is_seen;
        self.function & ENABLE | u8::from(rising) << 1 | u8::from(falling) << 2
    }

    /// Where the edges were seen last, and how often.
    pub(super) fn seen(&self) -> [(Option<f64>, u16); 2] {
        let [rising, falling] = self.positions;
        let [rises, falls] = self.counts;
        [(rising, rises), (falling, falls)]
    }
}
