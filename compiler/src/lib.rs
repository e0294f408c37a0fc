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
#[cfg(feature = "cli")]
pub mod project;
pub mod raw;
// some of it only the server for editors asks
#[cfg(feature = "cli")]
#[cfg_attr(not(feature = "lsp"), allow(dead_code))]
pub mod reference;
mod resolve;
pub mod rules;
pub mod sii;
pub mod source;
pub mod text;
#[cfg(feature = "cli")]
#[cfg_attr(not(feature = "lsp"), allow(dead_code, unused_imports))]
mod written;

pub use compile::{Compilation, Request, Stage, compile, compile_with};
