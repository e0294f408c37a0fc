//! The drives of all descriptions on a wire, with `ethercrab` as the master that knows nothing of them.
#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

mod bus;
#[path = "../shared/carried.rs"]
mod carried;
mod dictionary;
mod motion;
mod session;
#[path = "../shared/mod.rs"]
mod shared;
mod wireshark;
