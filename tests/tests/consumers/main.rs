//! Outputs read by what other people wrote, and programs compiled and run: what they make of bytes, words, codes and the
//! dictionary is what the JSON model says.
//!
//! The expected lines are computed here from the JSON alone, a bit at a time, so that C and Python share nothing with what
//! they are held against. Where there is no compiler or interpreter, the test says so and asks nothing.

#![cfg(test)]
#![allow(clippy::print_stderr)] // what is not asked is said

mod c;
mod eds;
mod expected;
mod icube;
mod igh;
mod lcec;
mod model;
mod python;
mod soes;
mod structured_text;
mod tools;
mod ways;
mod wireshark;
