//! Tests of devc as a whole, and the yardsticks they measure with.

pub mod manual;
