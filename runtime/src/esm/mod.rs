//! The EtherCAT state machine of a device (ETG.1000.6, EtherCAT state machine).
//!
//! A master writes AL control, and reads AL status and the AL status code. Between them is the [`StateMachine`]: it knows
//! which change may follow which state, and what has to hold for each:
//!
//! | change | what has to hold | else |
//! |---|---|---|
//! | Init to Pre-Operational | both mailboxes are where they are, and on | [`AlStatusCode::INVALID_MAILBOX`] |
//! | Pre-Operational to Safe-Operational | sync managers are as long as what is mapped | [`AlStatusCode::INVALID_OUTPUTS`], [`AlStatusCode::INVALID_INPUTS`] |
//! | Safe-Operational to Operational | outputs have come | [`AlStatusCode::NO_VALID_OUTPUTS`] |
//! | any | the firmware agrees | what it says |
//!
//! In Operational the [`Watchdog`] sees whether outputs come in time.

mod code;
mod machine;
mod managers;
mod registers;
mod watchdog;

pub use code::AlStatusCode;
pub use machine::{Application, Change, StateMachine};
pub use managers::{Area, Areas, Configured, Lengths};
pub use registers::{AlControl, AlState, AlStatus};
pub use watchdog::Watchdog;
