//! The EtherCAT state machine of a device (ETG.1000.6, EtherCAT state machine).
//!
//! A master writes AL control, and reads AL status and the AL status code. Between them is the [`StateMachine`]: it knows
//! which change may follow which state, and what has to hold for each:
//!
//! | change | what has to hold | else |
//! |---|---|---|
//! | Init to Pre-Operational | both mailboxes are where they are, and on | [`AlStatusCode::INVALID_MAILBOX`] |
//! | Pre-Operational to Safe-Operational | sync managers are as long as what is mapped | [`AlStatusCode::INVALID_OUTPUTS`], [`AlStatusCode::INVALID_INPUTS`] |
//! | | the clocks are set as the device takes them | [`AlStatusCode::INVALID_SYNC`], [`AlStatusCode::NO_FREE_RUN`], [`AlStatusCode::INVALID_CYCLE`], [`AlStatusCode::INVALID_SYNC0_CYCLE`], [`AlStatusCode::INVALID_SYNC1_CYCLE`] |
//! | | a watchdog that the outputs set off has a time | [`AlStatusCode::INVALID_WATCHDOG`] |
//! | Safe-Operational to Operational | outputs have come | [`AlStatusCode::NO_VALID_OUTPUTS`] |
//! | | signals of the clocks have come, if they are on | [`AlStatusCode::NO_SYNC_SIGNAL`] |
//! | any | the firmware agrees | what it says |
//!
//! In Operational the [`Watchdog`] sees whether outputs come in time. A device that looks at the clocks, or at the registers of its
//! watchdog, tells them by its [`Application`].

mod clocks;
mod code;
mod machine;
mod managers;
mod registers;
mod watchdog;

pub use clocks::{ClockMode, Clocked, Clocks};
pub use code::AlStatusCode;
pub use machine::{Application, Change, StateMachine};
pub use managers::{Area, Areas, Configured, Manager, Role};
pub use registers::{AlControl, AlState, AlStatus};
pub use watchdog::Watchdog;
