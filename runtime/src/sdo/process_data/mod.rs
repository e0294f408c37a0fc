//! Process data as the dictionary has it: what is mapped to PDOs, and which PDOs are assigned (ETG.1000.6, PDO mapping
//! and sync manager PDO assignment; CiA 301, PDO mapping parameter).

mod bits;
mod current;
mod image;
mod judge;
mod role;

pub use current::{Current, Mapped};
pub(super) use judge::counts_process_data;
pub use role::PdoRules;
