//! How long devc takes grows with its input, whatever is in it, or a limit says that it is too much.

#![cfg(test)]
#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

mod counted;
mod growth;
mod limits;

use std::path::Path;
use std::sync::Mutex;
use std::thread;

use devc::Compilation;
use devc::source::Memory;
use devc_tests::hostile::{self, Files, Kind};

fn compile(files: Files) -> Compilation {
    let files = files.into_iter().map(|(name, text)| (format!("drive/{name}"), text));
    let memory = files.fold(Memory::new(), |memory, (name, text)| memory.with(name, text));
    devc::compile(&memory, Path::new("drive"))
}

/// What is found of all kinds, looked at side by side.
fn found(judge: impl Fn(&'static Kind) -> Option<String> + Sync) -> Vec<String> {
    let kinds = Mutex::new(hostile::all());
    let next = || kinds.lock().expect("nobody panics here").next();
    let found = Mutex::new(Vec::new());
    let work = || {
        while let Some(kind) = next() {
            let fault = judge(kind);
            found.lock().expect("nobody panics here").extend(fault);
        }
    };
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    found.into_inner().expect("nobody panicked")
}
