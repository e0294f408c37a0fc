//! EEPROM images, read back by a reader that knows only the layout of ETG.1000.6.

#![cfg(test)]
#![allow(clippy::print_stderr)] // what is not asked for is said

mod corners;
mod hex;
mod like_esi;
mod published;
mod reader;
mod sizes;
