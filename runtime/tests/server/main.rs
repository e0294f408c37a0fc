//! The SDO server over a small dictionary: what is checked, in which order, and what a firmware can do.

#![cfg(test)]

mod complete;
mod device;
mod hooks;
mod single;
