//! Service data: single entries, read and written on request (CiA 301, SDO; ETG.1000.6, CoE).

mod abort;
mod access;
mod data_type;
mod dictionary;

pub use abort::AbortCode;
pub use access::{Access, CommunicationState};
pub use data_type::DataType;
pub use dictionary::{Dictionary, EntryInfo, Found, NONE, ObjectCode, ObjectInfo, Page, positions};
