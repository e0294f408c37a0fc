//! Objects of the dictionary as a master sees them (CiA 301, object dictionary).

mod access;
mod entry;
mod measured;
mod value;
mod width;
mod word;

pub use access::{Constant, Marker, ReadOnly, ReadWrite, Readable, Writable, WriteOnly};
pub use devc_start_up::Address;
pub use entry::Entry;
pub use value::Value;
pub use width::{
    Bit2, Bit3, Bit4, Bit5, Bit6, Bit7, Int, Int24, Int40, Int48, Int56, Uint, Uint24, Uint40, Uint48, Uint56,
};
pub use word::{BitField, show_word};
