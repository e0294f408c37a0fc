//! The CoE mailbox: CANopen application protocol over EtherCAT (ETG.1000.4, mailbox; ETG.1000.6, CoE).
//!
//! Messages are read from and written into byte slices as they are in the mailboxes, for both sides: what a master asks
//! and what a device answers. A message is an [`Envelope`] around what its service says:
//!
//! | service | a master sends | a device sends |
//! |---|---|---|
//! | SDO | [`Request`] | [`Response`] |
//! | SDO information | [`Information`] | [`Information`] with [`ObjectDescription`] and [`EntryDescription`] |
//! | emergency | | [`Emergency`] |
//!
//! [`Mailbox`] answers for a device, over its [`sdo::Server`](crate::sdo::Server). [`Upload`] and [`Download`] are transfers of a
//! master, message by message.

mod client;
mod describe;
mod emergency;
mod envelope;
mod information;
mod mailbox;
mod request;
mod response;
mod segment;
mod transfer;
mod writer;

pub use client::{Answered, Download, Failure, Upload};
pub use emergency::Emergency;
pub use envelope::{Envelope, MailboxError, Malformed, Protocol, Service};
pub use information::{EntryDescription, Information, ListKind, ObjectDescription, Operation};
pub use mailbox::Mailbox;
pub use request::Request;
pub use response::Response;
