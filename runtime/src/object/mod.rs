//! Objects of the dictionary as a master sees them (CiA 301, object dictionary).

mod access;
mod address;
mod entry;
mod value;

pub use access::{Constant, Marker, ReadOnly, ReadWrite, Readable, Writable, WriteOnly};
pub use address::Address;
pub use entry::Entry;
pub use value::Value;
