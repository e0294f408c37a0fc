//! Descriptions made of ESI files, and ESI files made of those again: both must mean the same.
//!
//! What a file means is read by `facts`, which shares no code with devc. What is not the same has to be in the report of
//! the import.

#![cfg(test)]
#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

mod corpus;
mod facts;
mod fixed_point;
mod hostile;
mod kinds;
mod languages;
mod listed;
mod modules;
mod objects;
mod oddities;
mod own_sheets;
mod profile;
mod remarks;
mod round_trip;
mod sdos;
mod sheets;
mod special;
mod spellings;
mod start_up;
mod texts;
mod told;
mod transport;
mod unusual;
