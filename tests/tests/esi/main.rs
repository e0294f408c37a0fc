//! The ESI output, read back.
//!
//! Two readers look at it: the crate `ethercat-esi`, and `devc_tests::esi_reader`. What they find has to be the
//! model, and to keep the rules that no schema can check.

#![cfg(test)]

mod crate_reader;
mod data_types;
mod dictionary;
mod head;
mod languages;
mod layout;
mod process_data;
mod slots;
mod start_up;
mod subjects;
mod sync_managers;
