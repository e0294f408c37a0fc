//! Messages as people and machines read them.

mod text;

pub use text::{Style, text};
