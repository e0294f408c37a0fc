//! Who may do what with an entry, and when.

use core::fmt;

use super::AbortCode;

/// The communication states in which a device has a mailbox (ETG.1000.6, EtherCAT state machine).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CommunicationState {
    /// Mailbox, no process data.
    PreOperational,
    /// Mailbox and inputs.
    SafeOperational,
    /// Mailbox, inputs and outputs.
    Operational,
}

impl CommunicationState {
    /// Where the state is among the three bits for reading; those for writing are three higher.
    const fn read_bit(self) -> u16 {
        match self {
            Self::PreOperational => 0x01,
            Self::SafeOperational => 0x02,
            Self::Operational => 0x04,
        }
    }

    const fn write_bit(self) -> u16 {
        match self {
            Self::PreOperational => 0x08,
            Self::SafeOperational => 0x10,
            Self::Operational => 0x20,
        }
    }
}

/// The rights of an entry, as the service "get entry description" tells them (ETG.1000.6, object access).
///
/// ```
/// use devc_runtime::sdo::{AbortCode, Access, CommunicationState::*};
///
/// // written before the step to safe-operational, the `P → S` of many manuals
/// let access = Access::READ.and(Access::WRITE_PRE_OPERATIONAL);
/// assert_eq!(access.to_string(), "rw (pre-op)");
/// assert_eq!(access.check_write(PreOperational), Ok(()));
/// assert_eq!(access.check_write(Operational), Err(AbortCode::DEVICE_STATE));
/// assert_eq!(Access::READ.check_write(Operational), Err(AbortCode::READ_ONLY));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Access(pub u16);

impl Access {
    /// Read in every state.
    pub const READ: Self = Self(0x07);
    /// Written in every state.
    pub const WRITE: Self = Self(0x38);
    /// Written in pre-operational.
    pub const WRITE_PRE_OPERATIONAL: Self = Self(0x08);
    /// Written in safe-operational.
    pub const WRITE_SAFE_OPERATIONAL: Self = Self(0x10);
    /// Written in operational.
    pub const WRITE_OPERATIONAL: Self = Self(0x20);
    /// Mappable to process data that the device receives.
    pub const RX_PDO: Self = Self(0x40);
    /// Mappable to process data that the device transmits.
    pub const TX_PDO: Self = Self(0x80);
    /// Part of a backup of the device.
    pub const BACKUP: Self = Self(0x0100);
    /// A setting.
    pub const SETTING: Self = Self(0x0200);

    /// Both rights.
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether all rights of `other` are among these.
    pub const fn includes(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }

    /// Whether the entry may be read in this state, and if not, the abort code that says why.
    pub const fn check_read(self, state: CommunicationState) -> Result<(), AbortCode> {
        self.check(state.read_bit(), Self::READ, AbortCode::WRITE_ONLY)
    }

    /// Whether the entry may be written in this state, and if not, the abort code that says why.
    pub const fn check_write(self, state: CommunicationState) -> Result<(), AbortCode> {
        self.check(state.write_bit(), Self::WRITE, AbortCode::READ_ONLY)
    }

    const fn check(self, needed: u16, in_any_state: Self, never: AbortCode) -> Result<(), AbortCode> {
        if self.0 & needed != 0 {
            Ok(())
        } else if self.0 & in_any_state.0 != 0 {
            Err(AbortCode::DEVICE_STATE)
        } else {
            Err(never)
        }
    }
}

impl fmt::Display for Access {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (read, write) = (self.0 & Self::READ.0 != 0, self.0 & Self::WRITE.0 != 0);
        f.write_str(match (read, write) {
            (true, true) => "rw",
            (true, false) => "ro",
            (false, true) => "wo",
            (false, false) => "none",
        })?;
        if write && !self.includes(Self::WRITE) {
            let states = [
                (Self::WRITE_PRE_OPERATIONAL, "pre-op"),
                (Self::WRITE_SAFE_OPERATIONAL, "safe-op"),
                (Self::WRITE_OPERATIONAL, "op"),
            ];
            let mut separator = " (";
            for (_, name) in states.iter().filter(|(right, _)| self.includes(*right)) {
                write!(f, "{separator}{name}")?;
                separator = ", ";
            }
            f.write_str(")")?;
        }
        Ok(())
    }
}
