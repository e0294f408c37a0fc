//! The compiler of device descriptions: TOML in; ESI, Markdown, JSON and Rust out.

#[cfg(feature = "lsp")]
pub mod assist;
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
#[cfg(feature = "cli")]
pub mod format;
#[cfg(feature = "import")]
pub mod import;
pub mod lint;
pub mod model;
mod profiles;
pub mod raw;
#[cfg(feature = "cli")]
pub mod reference;
mod resolve;
pub mod rules;
pub mod source;
pub mod text;
#[cfg(feature = "cli")]
mod written;

pub use compile::{Compilation, Stage, compile, compile_with};
