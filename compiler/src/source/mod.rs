//! The files read and the tree they were parsed into, in which each thing knows where it stands.
//!
//! It knows TOML and files, nothing of drives. All input goes through a [`Loader`]; the rest of the compiler never
//! touches a file system.

mod characters;
mod duplicate;
mod include;
pub(crate) mod keys;
mod limits;
mod load;
mod loader;
mod merge;
mod origin;
#[cfg(feature = "cli")]
mod owner;
pub(crate) mod parse;
pub mod plain;
mod settings;
#[cfg(test)]
mod tests;
mod tree;

pub(crate) use include::outside;
#[cfg(any(feature = "cli", feature = "wireshark"))]
pub(crate) use load::read_profile;
pub use load::{Document, MAIN_FILE, Profile, load};
pub(crate) use loader::or_here;
pub use loader::{Disk, Loader, MAX_SIZE, Memory, Opened};
pub use origin::Origin;
pub(crate) use origin::parts;
#[cfg(feature = "cli")]
pub use owner::owner;
pub use tree::{CanonicalKey, Key, Layer, Member, Members, Node, Table, Value};

pub use crate::text::{FileId, Location, SourceFile, Sources};
