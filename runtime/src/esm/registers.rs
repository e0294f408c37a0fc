//! AL control and AL status.

use crate::sdo::CommunicationState;

/// A state, by its number in AL control and AL status (ETG.1000.6, AL control).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum AlState {
    /// No communication but by registers.
    Init = 1,
    /// Mailbox.
    PreOperational = 2,
    /// Mailbox for a new firmware.
    Bootstrap = 3,
    /// Mailbox and inputs.
    SafeOperational = 4,
    /// Mailbox, inputs and outputs.
    Operational = 8,
}

impl AlState {
    /// The state of a number; none if there is no such state.
    pub const fn of(number: u8) -> Option<Self> {
        match number {
            1 => Some(Self::Init),
            2 => Some(Self::PreOperational),
            3 => Some(Self::Bootstrap),
            4 => Some(Self::SafeOperational),
            8 => Some(Self::Operational),
            _ => None,
        }
    }

    /// The state as a mailbox of CoE has it; none where there is none.
    pub const fn communication(self) -> Option<CommunicationState> {
        match self {
            Self::Init | Self::Bootstrap => None,
            Self::PreOperational => Some(CommunicationState::PreOperational),
            Self::SafeOperational => Some(CommunicationState::SafeOperational),
            Self::Operational => Some(CommunicationState::Operational),
        }
    }
}

/// What a master wrote into the register AL control, 0x0120 (ETG.1000.4, AL control).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AlControl(pub u16);

impl AlControl {
    /// A request for a state, and with it the acknowledgement of an error if need be.
    pub const fn request(state: AlState, acknowledges: bool) -> Self {
        Self(state as u16 | if acknowledges { 0x10 } else { 0 })
    }

    /// The number of the state that is asked for.
    pub const fn number(self) -> u8 {
        (self.0 & 0x0F) as u8
    }

    /// Whether an error is acknowledged.
    pub const fn acknowledges(self) -> bool {
        self.0 & 0x10 != 0
    }
}

/// What the device shows in the register AL status, 0x0130 (ETG.1000.4, AL status).
///
/// ```
/// use devc_runtime::esm::{AlState, AlStatus};
///
/// assert_eq!(AlStatus::new(AlState::SafeOperational, true).0, 0x14);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AlStatus(pub u16);

impl AlStatus {
    /// A state, with an error or without.
    pub const fn new(state: AlState, is_error: bool) -> Self {
        Self(state as u16 | if is_error { 0x10 } else { 0 })
    }
}
