//! The states, and what leads from one to another.

use super::managers::{at, mailboxes, process_data};
use super::{AlControl, AlState, AlStatus, AlStatusCode, Areas, Clocked, Clocks, Configured, Role, Watchdog};
use crate::sdo::CommunicationState;

/// A change of the state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Change {
    /// The state before.
    pub from: AlState,
    /// The state after.
    pub to: AlState,
}

/// What a firmware has to say to a change of the state. It agrees to everything unless it says otherwise; `()` does nothing.
pub trait Application {
    /// Before a change that is in order: the place to start what is needed in the new state. An error refuses the change;
    /// a way down is not refused, and what is returned there is shown with the new state.
    fn before(&mut self, _change: Change) -> Result<(), AlStatusCode> {
        Ok(())
    }

    /// Whether outputs have come since Safe-Operational, which Operational begins with.
    fn has_outputs(&self) -> bool {
        true
    }

    /// What the device takes of the distributed clocks, and how they are set; none for a device that does not look at them.
    fn clocks(&self) -> Option<(Clocks<'_>, Clocked)> {
        None
    }

    /// Whether signals of the clocks have come since they were switched on, which Operational begins with.
    fn has_signals(&self) -> bool {
        true
    }

    /// The watchdog as its registers are set; none for a device that does not look at them.
    fn watchdog(&self) -> Option<Watchdog> {
        None
    }
}

impl Application for () {}

/// The EtherCAT state machine of a device (ETG.1000.6, EtherCAT state machine).
///
/// An error is shown until the master acknowledges it; up to then only ways down are taken.
///
/// ```
/// use devc_runtime::esm::{AlControl, AlState, AlStatusCode, Areas, StateMachine};
///
/// let mut machine = StateMachine::new(Areas::NONE);
/// machine.request(AlControl(0x08), &[], &[], &mut ());
/// assert_eq!((machine.status().0, machine.code()), (0x11, AlStatusCode::INVALID_CHANGE));
/// machine.request(AlControl(0x12), &[], &[], &mut ());
/// assert_eq!((machine.state(), machine.code()), (AlState::PreOperational, AlStatusCode::NONE));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StateMachine {
    state: AlState,
    code: AlStatusCode,
    areas: Areas,
}

impl StateMachine {
    /// In Init.
    pub const fn new(areas: Areas) -> Self {
        Self { state: AlState::Init, code: AlStatusCode::NONE, areas }
    }

    /// The state.
    pub const fn state(&self) -> AlState {
        self.state
    }

    /// The state as the CoE mailbox has it; none where there is none.
    pub const fn communication(&self) -> Option<CommunicationState> {
        self.state.communication()
    }

    /// What the register AL status shows.
    pub const fn status(&self) -> AlStatus {
        AlStatus::new(self.state, self.is_error())
    }

    /// What the register AL status code shows.
    pub const fn code(&self) -> AlStatusCode {
        self.code
    }

    const fn is_error(&self) -> bool {
        self.code.0 != AlStatusCode::NONE.0
    }

    /// Takes what a master wrote into AL control; tells the change if there was one. The settings of the sync managers are by
    /// number, and so are the bytes of process data that each carries at present:
    /// [`Server::carried`](crate::sdo::Server::carried).
    pub fn request(
        &mut self,
        control: AlControl,
        managers: &[Configured],
        lengths: &[usize],
        application: &mut impl Application,
    ) -> Option<Change> {
        if control.acknowledges() {
            self.code = AlStatusCode::NONE;
        }
        let Some(to) = AlState::of(control.number()) else {
            self.code = AlStatusCode::UNKNOWN_STATE;
            return None;
        };
        let change = Change { from: self.state, to };
        if self.is_error() && !is_down(change) || change.from == to {
            return None;
        }
        let permitted = self.permit(change, managers, lengths, application);
        match permitted.and_then(|()| application.before(change)) {
            Err(code) if !is_down(change) || permitted.is_err() => {
                self.code = code;
                return None;
            }
            Err(code) => self.code = code,
            Ok(()) => {}
        }
        self.state = to;
        Some(change)
    }

    /// What is wrong in the state that the device is in: it falls back, and shows why. A device that loses outputs or
    /// synchronisation falls to Safe-Operational; it never goes up by this.
    pub fn fall(&mut self, to: AlState, code: AlStatusCode) -> Option<Change> {
        let change = Change { from: self.state, to };
        if !is_down(change) {
            return None;
        }
        (self.state, self.code) = (to, code);
        Some(change)
    }

    /// Outputs did not come in time: out of Operational to Safe-Operational.
    pub fn watchdog_expired(&mut self) -> Option<Change> {
        match self.state {
            AlState::Operational => self.fall(AlState::SafeOperational, AlStatusCode::WATCHDOG),
            _ => None,
        }
    }

    /// Signals of the clocks failed to come: out of Operational to Safe-Operational.
    pub fn signals_lost(&mut self) -> Option<Change> {
        match self.state {
            AlState::Operational => self.fall(AlState::SafeOperational, AlStatusCode::FATAL_SYNCHRONISATION),
            _ => None,
        }
    }

    fn permit(
        &self,
        change: Change,
        managers: &[Configured],
        lengths: &[usize],
        application: &impl Application,
    ) -> Result<(), AlStatusCode> {
        use AlState::{Bootstrap, Init, Operational, PreOperational, SafeOperational};
        let areas = self.areas;
        let fits = |is_right: bool, fault: AlStatusCode| if is_right { Ok(()) } else { Err(fault) };
        let mail = [Role::MailboxOut, Role::MailboxIn];
        match (change.from, change.to) {
            (Init, PreOperational) => {
                let is_right = mail.into_iter().all(|role| mailboxes(areas.of(role), managers, role));
                fits(is_right, AlStatusCode::INVALID_MAILBOX)
            }
            (Init, Bootstrap) if areas.boot.is_none() => Err(AlStatusCode::NO_BOOTSTRAP),
            (Init, Bootstrap) => {
                let is_right = mail.into_iter().all(|role| mailboxes(areas.of_boot(role), managers, role));
                fits(is_right, AlStatusCode::INVALID_BOOT_MAILBOX)
            }
            (PreOperational, SafeOperational) => {
                let is_right = |role| process_data(&areas, managers, lengths, role);
                fits(is_right(Role::Outputs), AlStatusCode::INVALID_OUTPUTS)?;
                fits(is_right(Role::Inputs), AlStatusCode::INVALID_INPUTS)?;
                let outputs = areas.of(Role::Outputs).map(|(number, _)| at(managers, number));
                let is_timeless = |watchdog: Watchdog| watchdog.timeout_ns() == 0;
                if outputs.into_iter().any(|outputs| outputs.is_on && outputs.is_watched())
                    && application.watchdog().is_some_and(is_timeless)
                {
                    return Err(AlStatusCode::INVALID_WATCHDOG);
                }
                application.clocks().map_or(Ok(()), |(clocks, clocked)| clocks.judge(clocked))
            }
            (SafeOperational, Operational) if has_any(areas, lengths) && !application.has_outputs() => {
                Err(AlStatusCode::NO_VALID_OUTPUTS)
            }
            (SafeOperational, Operational)
                if application.clocks().is_some_and(|(_, clocked)| clocked.is_on())
                    && !application.has_signals() =>
            {
                Err(AlStatusCode::NO_SYNC_SIGNAL)
            }
            (SafeOperational, Operational) | (_, Init) => Ok(()),
            (SafeOperational | Operational, PreOperational) | (Operational, SafeOperational) => Ok(()),
            _ => Err(AlStatusCode::INVALID_CHANGE),
        }
    }
}

/// Whether any outputs are mapped.
fn has_any(areas: Areas, lengths: &[usize]) -> bool {
    areas.of(Role::Outputs).any(|(number, _)| lengths.get(number).is_some_and(|length| *length > 0))
}

/// Whether a change leads to a state with less communication, which is taken whatever is wrong.
fn is_down(change: Change) -> bool {
    use AlState::{Bootstrap, Init, Operational, PreOperational, SafeOperational};
    matches!(
        (change.from, change.to),
        (PreOperational | Bootstrap | SafeOperational | Operational, Init)
            | (SafeOperational | Operational, PreOperational)
            | (Operational, SafeOperational)
    )
}

#[cfg(test)]
mod tests {
    use super::super::{ClockMode, Manager};
    use super::*;

    const AREAS: Areas = Areas { managers: &[Manager::new(Role::Outputs, 0x1100, (0, 64))], boot: None };
    const BY_SYNC0: &[ClockMode] = &[ClockMode { assign_activate: 0x0300, sync0_ns: None, sync1_ns: None }];

    struct Firmware {
        clocked: Clocked,
        has_signals: bool,
        watchdog: Watchdog,
    }

    impl Application for Firmware {
        fn clocks(&self) -> Option<(Clocks<'_>, Clocked)> {
            Some((Clocks { modes: BY_SYNC0, least_ns: 250_000, choices_ns: &[] }, self.clocked))
        }

        fn has_signals(&self) -> bool {
            self.has_signals
        }

        fn watchdog(&self) -> Option<Watchdog> {
            Some(self.watchdog)
        }
    }

    /// Goes up to Operational as far as it gets, and tells where it stands and why.
    fn risen(firmware: &mut Firmware) -> (AlState, AlStatusCode) {
        let mut machine = StateMachine::new(AREAS);
        let outputs = Configured { address: 0x1100, length: 6, control: 0x64, is_on: true };
        for state in [AlState::PreOperational, AlState::SafeOperational, AlState::Operational] {
            let control = AlControl::request(state, false);
            if machine.request(control, &[outputs], &[6], firmware).is_none() {
                break;
            }
        }
        (machine.state(), machine.code())
    }

    /// ETG.1000.6, AL status codes.
    #[test]
    fn clocks_and_watchdog_are_judged_on_the_way_up() {
        let good = || Firmware {
            clocked: Clocked { activation: 0x03, sync0_ns: 1_000_000, sync1_ns: 0 },
            has_signals: true,
            watchdog: Watchdog::of_registers(2498, 1000),
        };
        assert_eq!(risen(&mut good()), (AlState::Operational, AlStatusCode::NONE));
        let with = |clocked| Firmware { clocked, ..good() };
        let set = |activation, sync0_ns| Clocked { activation, sync0_ns, sync1_ns: 0 };
        for (mut firmware, state, code) in [
            (with(set(0, 0)), AlState::PreOperational, 0x0027),
            (with(set(0x07, 1_000_000)), AlState::PreOperational, 0x0030),
            (with(set(0x03, 100_000)), AlState::PreOperational, 0x0036),
            (Firmware { watchdog: Watchdog::new(0), ..good() }, AlState::PreOperational, 0x001F),
            (Firmware { has_signals: false, ..good() }, AlState::SafeOperational, 0x002D),
        ] {
            assert_eq!(risen(&mut firmware), (state, AlStatusCode(code)));
        }
    }
}
