//! The states, and what leads from one to another.

use super::managers::{mailboxes, process_data};
use super::{AlControl, AlState, AlStatus, AlStatusCode, Areas, Configured, Lengths};
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
}

impl Application for () {}

/// The EtherCAT state machine of a device (ETG.1000.6, EtherCAT state machine).
///
/// An error is shown until the master acknowledges it; up to then only ways down are taken.
///
/// ```
/// use devc_runtime::esm::{AlControl, AlState, AlStatusCode, Areas, Configured, Lengths, StateMachine};
///
/// let areas = Areas {
///     mailbox_out: None, mailbox_in: None, boot_out: None, boot_in: None, outputs: None, inputs: None,
/// };
/// let mut machine = StateMachine::new(areas);
/// let (managers, lengths) = ([Configured::default(); 4], Lengths { outputs: 0, inputs: 0 });
/// machine.request(AlControl(0x08), &managers, lengths, &mut ());
/// assert_eq!((machine.status().0, machine.code()), (0x11, AlStatusCode::INVALID_CHANGE));
/// machine.request(AlControl(0x12), &managers, lengths, &mut ());
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

    /// Takes what a master wrote into AL control, with the settings of sync managers 0 to 3 and the present lengths of process
    /// data; tells the change if there was one.
    pub fn request(
        &mut self,
        control: AlControl,
        managers: &[Configured; 4],
        lengths: Lengths,
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

    fn permit(
        &self,
        change: Change,
        managers: &[Configured; 4],
        lengths: Lengths,
        application: &impl Application,
    ) -> Result<(), AlStatusCode> {
        use AlState::{Bootstrap, Init, Operational, PreOperational, SafeOperational};
        let Areas { mailbox_out, mailbox_in, boot_out, boot_in, .. } = self.areas;
        match (change.from, change.to) {
            (Init, PreOperational) => {
                mailboxes([mailbox_out, mailbox_in], managers, AlStatusCode::INVALID_MAILBOX)
            }
            (Init, Bootstrap) if boot_out.is_none() => Err(AlStatusCode::NO_BOOTSTRAP),
            (Init, Bootstrap) => mailboxes([boot_out, boot_in], managers, AlStatusCode::INVALID_BOOT_MAILBOX),
            (PreOperational, SafeOperational) => process_data(&self.areas, managers, lengths),
            (SafeOperational, Operational) if lengths.outputs > 0 && !application.has_outputs() => {
                Err(AlStatusCode::NO_VALID_OUTPUTS)
            }
            (SafeOperational, Operational) | (_, Init) => Ok(()),
            (SafeOperational | Operational, PreOperational) | (Operational, SafeOperational) => Ok(()),
            _ => Err(AlStatusCode::INVALID_CHANGE),
        }
    }
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
