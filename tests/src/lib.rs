//! Tests of devc as a whole, and the yardsticks they measure with.

pub mod esi_reader;
pub mod manual;
