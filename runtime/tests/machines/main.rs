//! The machines of both sides against the manuals, each state with each word.

mod coupling;
mod device;
mod drive;
mod handshake;
mod master;
mod modes;
mod observer;
mod plant;
