//! Messages as people and machines read them.

#[cfg(test)]
mod tests;
mod text;

pub use text::{Style, text};
