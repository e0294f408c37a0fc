//! What a master sets the distributed clocks to, against what the device takes.

use super::AlStatusCode;

/// A way to keep time with the master, as the ESI has it in an `OpMode`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ClockMode {
    /// The value of the registers 0x0980 and 0x0981, `AssignActivate`; 0 for a device that runs by itself.
    pub assign_activate: u16,
    /// The period of SYNC0 in nanoseconds, if it is a fixed one; none if it follows the master.
    pub sync0_ns: Option<u32>,
    /// The period of SYNC1 in nanoseconds, if it is a fixed one; none if it follows the master.
    pub sync1_ns: Option<u32>,
}

/// What a device takes of the distributed clocks.
///
/// ```
/// use devc_runtime::esm::{AlStatusCode, ClockMode, Clocked, Clocks};
///
/// let by_sync0 = ClockMode { assign_activate: 0x0300, sync0_ns: None, sync1_ns: None };
/// let clocks = Clocks { modes: &[by_sync0], least_ns: 250_000, choices_ns: &[] };
/// let set = |activation, sync0_ns| Clocked { activation, sync0_ns, sync1_ns: 0 };
/// assert_eq!(clocks.judge(set(0x03, 1_000_000)), Ok(()));
/// assert_eq!(clocks.judge(set(0x07, 1_000_000)), Err(AlStatusCode::INVALID_SYNC));
/// assert_eq!(clocks.judge(set(0x03, 125_000)), Err(AlStatusCode::INVALID_SYNC0_CYCLE));
/// assert_eq!(clocks.judge(set(0x00, 0)), Err(AlStatusCode::NO_FREE_RUN));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Clocks<'a> {
    /// The ways to keep time; none if the device does not look at the clocks.
    pub modes: &'a [ClockMode],
    /// The shortest period of SYNC0 in nanoseconds; 0 if there is none.
    pub least_ns: u32,
    /// The only periods of SYNC0 in nanoseconds; none if any is taken.
    pub choices_ns: &'a [u32],
}

/// The registers of the distributed clocks that say what a master wants: 0x0981, 0x09A0 and 0x09A4 (ETG.1000.4,
/// distributed clock).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Clocked {
    /// 0x0981: which signals are made.
    pub activation: u8,
    /// 0x09A0: the period of SYNC0 in nanoseconds.
    pub sync0_ns: u32,
    /// 0x09A4: what SYNC1 adds to it in nanoseconds.
    pub sync1_ns: u32,
}

impl Clocked {
    /// Whether the unit that makes the signals is on: bit 0 of the activation.
    pub const fn is_on(self) -> bool {
        self.activation & 0x01 != 0
    }

    /// Whether SYNC0 is made.
    pub const fn has_sync0(self) -> bool {
        self.is_on() && self.activation & 0x02 != 0
    }

    /// Whether SYNC1 is made.
    pub const fn has_sync1(self) -> bool {
        self.is_on() && self.activation & 0x04 != 0
    }
}

impl Clocks<'_> {
    /// Whether the device takes what is set; the code is that of ETG.1000.6, AL status codes.
    pub fn judge(&self, clocked: Clocked) -> Result<(), AlStatusCode> {
        if self.modes.is_empty() {
            return Ok(());
        }
        let signals = |activation: u8| if activation & 0x01 == 0 { 0 } else { activation & 0x07 };
        let wanted = signals(clocked.activation);
        let of = |mode: &&ClockMode| {
            let [activation, _] = mode.assign_activate.to_be_bytes();
            signals(activation) == wanted
        };
        let Some(mode) = self.modes.iter().find(of) else {
            return Err(if wanted == 0 { AlStatusCode::NO_FREE_RUN } else { AlStatusCode::INVALID_SYNC });
        };
        if clocked.has_sync0() {
            self.judge_sync0(mode, clocked.sync0_ns)?;
        }
        match mode.sync1_ns {
            Some(period) if clocked.has_sync1() && period != clocked.sync1_ns => {
                Err(AlStatusCode::INVALID_SYNC1_CYCLE)
            }
            _ => Ok(()),
        }
    }

    fn judge_sync0(&self, mode: &ClockMode, period: u32) -> Result<(), AlStatusCode> {
        if period == 0 || period < self.least_ns || mode.sync0_ns.is_some_and(|fixed| fixed != period) {
            return Err(AlStatusCode::INVALID_SYNC0_CYCLE);
        }
        if !self.choices_ns.is_empty() && !self.choices_ns.contains(&period) {
            return Err(AlStatusCode::INVALID_CYCLE);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FREE: ClockMode = ClockMode { assign_activate: 0, sync0_ns: None, sync1_ns: None };
    const SYNC0: ClockMode = ClockMode { assign_activate: 0x0300, sync0_ns: None, sync1_ns: None };
    const BOTH: ClockMode = ClockMode { assign_activate: 0x0700, sync0_ns: None, sync1_ns: Some(500_000) };

    fn judged(modes: &[ClockMode], activation: u8, sync0_ns: u32, sync1_ns: u32) -> Result<(), AlStatusCode> {
        let clocks = Clocks { modes, least_ns: 250_000, choices_ns: &[250_000, 1_000_000] };
        clocks.judge(Clocked { activation, sync0_ns, sync1_ns })
    }

    #[test]
    fn a_device_without_clocks_does_not_mind_them() {
        assert_eq!(judged(&[], 0x07, 1, 1), Ok(()));
    }

    #[test]
    fn free_run_is_a_mode_of_its_own() {
        assert_eq!(judged(&[FREE, SYNC0], 0, 0, 0), Ok(()));
        // signals that are chosen do not come while the unit is off
        assert_eq!(judged(&[FREE, SYNC0], 0x06, 0, 0), Ok(()));
        assert_eq!(judged(&[SYNC0], 0, 0, 0), Err(AlStatusCode::NO_FREE_RUN));
    }

    #[test]
    fn signals_are_those_of_a_mode() {
        assert_eq!(judged(&[SYNC0], 0x03, 1_000_000, 0), Ok(()));
        assert_eq!(judged(&[SYNC0], 0x05, 1_000_000, 0), Err(AlStatusCode::INVALID_SYNC));
        assert_eq!(judged(&[SYNC0, BOTH], 0x07, 1_000_000, 500_000), Ok(()));
        assert_eq!(judged(&[BOTH], 0x07, 1_000_000, 1), Err(AlStatusCode::INVALID_SYNC1_CYCLE));
    }

    #[test]
    fn periods_are_those_that_the_device_takes() {
        assert_eq!(judged(&[SYNC0], 0x03, 0, 0), Err(AlStatusCode::INVALID_SYNC0_CYCLE));
        assert_eq!(judged(&[SYNC0], 0x03, 100_000, 0), Err(AlStatusCode::INVALID_SYNC0_CYCLE));
        assert_eq!(judged(&[SYNC0], 0x03, 500_000, 0), Err(AlStatusCode::INVALID_CYCLE));
        assert_eq!(judged(&[SYNC0], 0x03, 250_000, 0), Ok(()), "the least is one of them");
    }
}
