//! What a mode adds to controlword and statusword, on the side of the master.
//!
//! Each handshake puts its bits into the controlword of an [`Output`](super::Output), and only while that allows
//! motion: where the drive is stopped, starts and set-points are gone with it.

mod halt;
mod homing;
mod set_point;

pub use halt::{Halt, HaltProgress};
pub use homing::{Homing, HomingBits, HomingProgress};
pub use set_point::{Move, SetPointProgress, SetPoints};
