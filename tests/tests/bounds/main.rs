//! How long devc takes grows with its input, whatever is in it, or a limit says that it is too much.

#![cfg(test)]
#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

mod growth;
mod limits;

use std::path::Path;

use devc::Compilation;
use devc::source::Memory;
use devc_tests::hostile::Files;

fn compile(files: Files) -> Compilation {
    let files = files.into_iter().map(|(name, text)| (format!("drive/{name}"), text));
    let memory = files.fold(Memory::new(), |memory, (name, text)| memory.with(name, text));
    devc::compile(&memory, Path::new("drive"))
}
