//! The compiler of device descriptions: TOML in; ESI, Markdown, JSON and Rust out.

pub mod diagnostic;
pub mod emit;
pub mod lint;
pub mod model;
pub mod source;
