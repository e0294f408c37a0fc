//! Messages as people and machines read them.

mod github;
#[cfg(feature = "json")]
mod json;
pub(crate) mod position;
#[cfg(feature = "json")]
mod sarif;
#[cfg(test)]
mod tests;
mod text;
mod window;

pub use github::github;
#[cfg(feature = "json")]
pub use json::json;
#[cfg(feature = "json")]
pub use sarif::sarif;
pub use text::{Style, text};
