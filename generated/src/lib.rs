//! The Rust that devc makes of the descriptions it ships: a module for each device.
//!
//! The modules are written by `devc build` and never edited; this list of them is kept by hand.
#![no_std]

#[rustfmt::skip]
#[path = "../c887/c887.rs"]
pub mod c887;

#[rustfmt::skip]
#[path = "../pmc-sc6/pmc-sc6.rs"]
pub mod pmc_sc6;

#[rustfmt::skip]
#[path = "../s700/s700.rs"]
pub mod s700;
