//! What a device makes of the distributed clocks.

use std::time::Duration;

use devc::model::{Device, SyncMode};
use devc_runtime::esm::AlStatusCode;

use crate::{Clocks, Event};

/// The ways to keep time that a device has.
#[derive(Debug, Clone)]
pub(super) struct ClockModes {
    /// Whether each has SYNC0 and SYNC1.
    signals: Vec<[bool; 2]>,
    /// The shortest cycle of all that the description names.
    shortest: Option<Duration>,
}

impl ClockModes {
    pub(super) fn new(device: &Device) -> Self {
        let cycles = device.cycle_times.iter().flat_map(|it| it.min.iter().chain(&it.choices));
        let shortest = cycles.map(|cycle| cycle.0).min();
        Self {
            signals: device.clock_modes().iter().map(signals).collect(),
            shortest: shortest.map(Duration::from_nanos),
        }
    }

    /// Whether the device can work with what a master has set (ETG.1000.6, AL status codes). It works without signals, too.
    ///
    /// It is not what `esm::Clocks` says, which is as strict as a description: that would refuse a master without clocks, and a
    /// cycle that is too short, where this device goes on and complains.
    pub(super) fn judge(&self, clocks: Clocks) -> Result<(), AlStatusCode> {
        let asked = [clocks.sync0.is_some(), clocks.sync1.is_some()];
        match clocks.sync0 {
            _ if !clocks.are_active() => Ok(()),
            _ if !self.signals.contains(&asked) => Err(AlStatusCode::INVALID_SYNC),
            Some(Duration::ZERO) => Err(AlStatusCode::INVALID_SYNC0_CYCLE),
            _ => Ok(()),
        }
    }

    /// What a master should know of a choice that the device takes.
    pub(super) fn complaint(&self, clocks: Clocks) -> Option<Event> {
        let is_other = |signals: &[bool; 2]| *signals == [false; 2];
        if !clocks.are_active() {
            let needs_clocks = !self.signals.is_empty() && !self.signals.iter().any(is_other);
            return needs_clocks.then_some(Event::WithoutClocks);
        }
        let (cycle, shortest) = (clocks.sync0?, self.shortest?);
        (cycle < shortest).then_some(Event::ShortCycle { cycle, shortest })
    }
}

/// The signals that a mode starts, by the bits that it writes into register 0x0981.
fn signals(mode: &SyncMode) -> [bool; 2] {
    let [_, activation] = mode.assign_activate.to_le_bytes();
    [0x02, 0x04].map(|bit| activation & bit != 0)
}
