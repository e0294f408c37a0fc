//! Frames as they are on the wire (ETG.1000.4, DLPDU).

mod command;
mod datagram;
mod ethernet;

pub(crate) use command::{Command, Target};
pub(crate) use datagram::{Datagram, Datagrams};
pub(crate) use ethernet::{datagrams, mark_returned};
