//! EEPROM images, read back by a reader that knows only the layout of ETG.1000.6.

#![cfg(test)]

mod corners;
mod hex;
mod like_esi;
mod reader;
mod sizes;
