//! What happens on the wire that somebody should know of, in words.

mod fault;

use std::fmt;
use std::time::Duration;

use devc_runtime::coe::MailboxError;
use devc_runtime::esm::{AlState, AlStatusCode};
use devc_runtime::object::Address;
use devc_runtime::sdo::AbortCode;

pub(crate) use fault::faults;
pub use fault::{ManagerFault, Wrong};

/// Something that a master has done, or has done wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Event {
    /// The state changed, as the master asked for.
    Changed {
        /// The state now; none if what AL status shows is no state.
        state: Option<AlState>,
    },
    /// The device does not go to the state that the master asks for.
    Refused {
        /// The state that was asked for; none for a number that is no state.
        asked: Option<AlState>,
        /// Why.
        code: AlStatusCode,
        /// What is wrong with sync managers, if it is that.
        faults: Vec<ManagerFault>,
    },
    /// The device left a state by itself.
    Fell {
        /// The state now.
        state: Option<AlState>,
        /// Why.
        code: AlStatusCode,
    },
    /// No outputs came in the time of the watchdog.
    WatchdogExpired {
        /// The time that the master has set.
        timeout: Duration,
    },
    /// An SDO transfer was aborted by the device.
    SdoAborted {
        /// The entry.
        address: Address,
        /// Why.
        code: AbortCode,
    },
    /// A mailbox message could not be read.
    MailRefused {
        /// Why.
        error: MailboxError,
    },
    /// A file was refused, which a master wrote or asked for.
    FileRefused {
        /// Why, by the codes of FoE (ETG.1000.6).
        code: u32,
    },
    /// A register was written that a master cannot write, or not now.
    NotWritable {
        /// The first address.
        address: u16,
    },
    /// Two sync managers share memory. Those of process data take three times their length.
    Overlap {
        /// Their numbers.
        managers: (usize, usize),
    },
    /// A sync manager of process data was changed while process data is exchanged, which then stands still.
    ManagersChanged,
    /// The device went to Operational without distributed clocks, which are the only way that it is said to keep time.
    WithoutClocks,
    /// SYNC0 comes more often than the device is said to be able to follow.
    ShortCycle {
        /// The cycle that the master has set.
        cycle: Duration,
        /// The shortest of the description.
        shortest: Duration,
    },
    /// A write set off what the description says of it.
    Triggered {
        /// The entry.
        address: Address,
        /// What it does.
        action: String,
    },
    /// Parameters were stored, and are there after a power cycle.
    Stored,
    /// After a power cycle parameters are as the device was delivered.
    Restored,
    /// A datagram went to a station that there is not.
    NoStation {
        /// The station address.
        station: u16,
    },
    /// A datagram went to a position behind the last subdevice.
    NoPosition {
        /// The position, from 0.
        position: u16,
    },
    /// Process data went to where no FMMU maps any.
    Unmapped {
        /// The logical address.
        address: u32,
        /// The bytes of the datagram.
        length: usize,
    },
}

impl Event {
    /// Whether the master did something wrong.
    pub const fn is_complaint(&self) -> bool {
        !matches!(self, Self::Changed { .. } | Self::Triggered { .. } | Self::Stored | Self::Restored)
    }
}

impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Changed { state } => write!(f, "is in {}", state_name(*state)),
            Self::Refused { asked, code, faults } => {
                write!(f, "does not go to {}: {code}", state_name(*asked))?;
                faults.iter().try_for_each(|fault| write!(f, "; {fault}"))
            }
            Self::Fell { state, code } => write!(f, "fell to {}: {code}", state_name(*state)),
            Self::WatchdogExpired { timeout } => {
                write!(f, "no outputs came for {timeout:?}, which is the time of the watchdog")
            }
            Self::SdoAborted { address, code } => write!(f, "aborts the SDO transfer of {address}: {code}"),
            Self::MailRefused { error: MailboxError(code) } => {
                write!(f, "cannot read a mailbox message: error {code} of ETG.1000.4, mailbox error reply")
            }
            Self::FileRefused { code } => write!(f, "refuses a file: error 0x{code:04X} of ETG.1000.6, FoE"),
            Self::NotWritable { address } => {
                write!(f, "register 0x{address:04X} was written, which cannot be written now")
            }
            Self::Overlap { managers: (first, second) } => {
                write!(f, "sync managers {first} and {second} share memory")?;
                f.write_str("; those of process data take three times their length")
            }
            Self::ManagersChanged => f.write_str(
                "process data stands still, as its sync managers were changed behind Pre-Operational",
            ),
            Self::WithoutClocks => f.write_str(
                "runs without SYNC0, while distributed clocks are the only way in which it is said to keep time",
            ),
            Self::ShortCycle { cycle, shortest } => {
                write!(f, "SYNC0 comes every {cycle:?}, while its shortest cycle is {shortest:?}")
            }
            Self::Triggered { address, action } => write!(f, "{address} sets off: {action}"),
            Self::Stored => f.write_str("stores parameters"),
            Self::Restored => f.write_str("restores parameters, with effect after a power cycle"),
            Self::NoStation { station } => {
                write!(f, "a datagram went to station 0x{station:04X}, which there is not")
            }
            Self::NoPosition { position } => {
                write!(f, "a datagram went to position {position}, which there is not")
            }
            Self::Unmapped { address, length } => {
                let end = u64::from(*address) + *length as u64;
                write!(f, "no FMMU maps any of the process data from 0x{address:08X} to 0x{end:08X}")
            }
        }
    }
}

/// The state in words; of a number that is no state, that it is none.
pub fn state_name(state: Option<AlState>) -> &'static str {
    match state {
        Some(AlState::Init) => "Init",
        Some(AlState::PreOperational) => "Pre-Operational",
        Some(AlState::Bootstrap) => "Bootstrap",
        Some(AlState::SafeOperational) => "Safe-Operational",
        Some(AlState::Operational) => "Operational",
        None => "a state that there is not",
    }
}
