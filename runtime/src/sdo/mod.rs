//! Service data: single entries, read and written on request (CiA 301, SDO; ETG.1000.6, CoE).
//!
//! A firmware keeps a generated struct of values and a [`Server`] over it:
//!
//! | | |
//! |---|---|
//! | [`Dictionary`] | the table of all entries, by address: type, length, rights, where the value is |
//! | [`Values`] | the way from a place in the table to the value; generated |
//! | [`Hooks`] | what the firmware does at a transfer |
//! | [`Server`] | uploads and downloads, each with its checks and abort codes; process data as it is mapped at present |

mod abort;
mod access;
mod complete;
mod data_type;
mod dictionary;
mod hooks;
mod kept;
mod layout;
mod list;
mod names;
mod part;
mod process_data;
mod range;
mod server;
pub mod shorthand;
mod table;
mod values;

pub use abort::AbortCode;
pub use access::{Access, CommunicationState};
pub use data_type::DataType;
pub use dictionary::{Dictionary, Found, NONE, Page, positions};
pub use hooks::Hooks;
pub use kept::Kept;
pub use list::List;
pub use names::Names;
pub use part::Part;
pub use process_data::{Current, Mapped, PdoRules};
pub use range::{Limits, Range};
pub use server::Server;
pub(crate) use server::found;
pub use table::{EntryInfo, ObjectCode, ObjectInfo};
pub use values::{Place, Slot, Values};
