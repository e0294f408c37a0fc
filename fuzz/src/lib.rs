//! What holds for whatever anybody writes or sends, and inputs that look for something for which it does not.
//!
//! Each file is about one thing that devc is given. Bytes become an input of that kind (edits of a description, messages,
//! frames), and a property says what has to hold of what devc makes of it. `cargo test -p devc-fuzz` asks the inputs that
//! are kept in `corpus`, and a few that look like chance and are the same each time; `.ci/fuzz` looks for new ones as long
//! as one likes, and is led by what they reach in the code. See `compiler/docs/testing.md`.

#![cfg(test)]
#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

mod compare;
mod editor;
mod edits;
mod frames;
mod front;
mod import;
mod layout;
mod mailbox;
mod run;
mod subjects;
mod xml;
