//! What changes from one version of a family to the next, and whom it breaks.
//!
//! `model::compare` finds what differs; here each difference is judged from the view of an *old configuration on the new
//! device*: a master project, a program or a start-up list that was made for the old description and is left as it is.

mod change;
mod changes;
mod gate;
mod judge;
mod kinds;
mod place;
mod render;

pub use change::{Change, Class, Kind};
pub use changes::{Comparison, Versioned, compare};
pub use gate::{Gate, gate};
pub use kinds::{ALL, find, reference};
pub use render::{findings, json, markdown, rules, text};
