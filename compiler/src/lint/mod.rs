//! The rules: what is wrong with a device although it could be read.

mod checked;

pub use checked::Checked;
