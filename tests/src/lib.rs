//! Tests of devc as a whole, and the yardsticks they measure with.

pub mod esi_reader;
pub mod hostile;
pub mod manual;

/// The code in the guide to drive code, as tests.
#[cfg(doctest)]
#[doc = include_str!("../../compiler/docs/drive-code.md")]
pub mod drive_code {}
