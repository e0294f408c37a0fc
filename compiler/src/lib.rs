//! The compiler of device descriptions: TOML in; ESI, Markdown, JSON and Rust out.

#[cfg(feature = "build")]
pub mod build;
mod compile;
#[cfg(feature = "derive")]
pub mod derive;
pub mod diagnostic;
#[cfg(feature = "diff")]
pub mod diff;
pub mod emit;
#[cfg(feature = "cli")]
pub mod explain;
#[cfg(feature = "import")]
pub mod import;
pub mod lint;
pub mod model;
mod profiles;
pub mod raw;
mod resolve;
pub mod rules;
pub mod sii;
pub mod source;
pub mod text;

pub use compile::{Compilation, Stage, compile, compile_with};

/// The JSON schema of descriptions, for editors; tests hold it to the code.
#[cfg(feature = "cli")]
pub const SCHEMA: &str = include_str!("../schema/device.schema.json");
