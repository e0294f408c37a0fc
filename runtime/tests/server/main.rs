//! The SDO server and the CoE mailbox over a small dictionary: what is checked, in which order, what a firmware can do,
//! and what goes over the wire.

#![cfg(test)]

mod client;
mod complete;
mod device;
mod hooks;
mod information;
mod master;
mod messages;
mod rights;
mod served;
mod single;
mod wire;
