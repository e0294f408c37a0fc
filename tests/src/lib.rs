//! Tests of devc as a whole, and the yardsticks they measure with.

pub mod esi_reader;
pub mod hostile;
pub mod manual;

/// The beginning of a small description, with what each has to have.
pub const HEAD: &str = r#"
source = "the file"

[device]
name   = "Drive"
vendor = "Vendor"

[identity]
vendor-id    = 1
product-code = 2
revision     = 3
"#;

/// The code in the guide to drive code, as tests.
#[cfg(doctest)]
#[doc = include_str!("../../compiler/docs/drive-code.md")]
pub mod drive_code {}
