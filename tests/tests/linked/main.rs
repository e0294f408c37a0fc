//! What runs in a device has nothing to panic or to allocate with: shown by linking it without either.
//!
//! `firmware/` is a program without `std`, without `alloc` and without a start file, over the runtime and the
//! generated modules of all devices: process data, the dictionary with its server and mailbox, the machines of both
//! sides. Its panic handler calls a function that does not exist. So it links only if nothing that it reaches can
//! panic. It is not a package, for the packages of this workspace forbid the `unsafe` that such a handler needs.
#![cfg(test)]
#![cfg(target_os = "linux")]

use std::path::Path;
use std::process::{Command, Output};

/// What the handler calls.
const MISSING: &str = "a_panic_can_be_reached";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The compiler, to make what has to run without cargo's choices.
fn rustc(optimised: &str, out: &Path) -> Command {
    let mut rustc = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
    rustc.args(["--edition=2024", "-Cpanic=abort", "-Cdebug-assertions=no", "-Awarnings", "--out-dir"]);
    rustc.arg(out).arg(format!("-Copt-level={optimised}"));
    rustc
}

/// Compiles a library, over another one or over none.
fn library(name: &str, folder: &str, over: Option<&str>, optimised: &str, out: &Path) {
    let mut library = rustc(optimised, out);
    library.arg(format!("--crate-name={name}")).args(["--crate-type=rlib", "-L"]).arg(out);
    library.args(over.into_iter().flat_map(|other| ["--extern", other]));
    let output = library.arg(root().join(folder).join("src/lib.rs")).output().expect("there is a compiler");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Compiles the runtime and what it stands on, then the firmware with it.
fn link(optimised: &str, flags: &[&str], out: &Path) -> Output {
    library("devc_start_up", "../start-up", None, optimised, out);
    library("devc_runtime", "../runtime", Some("devc_start_up"), optimised, out);
    let mut firmware = rustc(optimised, out);
    firmware.args(["--crate-name=firmware", "-Clink-arg=-nostartfiles"]);
    // for `memcpy` and its like, which the compiler calls for copies
    firmware.arg("-Clink-arg=-lc").args(flags).arg("-L").arg(out).args(["--extern", "devc_runtime"]);
    firmware.arg(root().join("tests/linked/firmware/main.rs"));
    firmware.output().expect("there is a compiler")
}

/// The firmware, which links and calls nothing that allocates.
fn linked(optimised: &str, flags: &[&str]) -> Vec<u8> {
    let out = tempfile::tempdir().expect("there is room");
    let output = link(optimised, flags, out.path());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let firmware = std::fs::read(out.path().join("firmware")).expect("the firmware is linked");
    assert!(!names(&firmware, "malloc") && !names(&firmware, "__rust_alloc"));
    firmware
}

fn names(firmware: &[u8], name: &str) -> bool {
    firmware.windows(name.len()).any(|bytes| bytes == name.as_bytes())
}

#[test]
fn nothing_can_panic_or_allocate_in_fast_code() {
    linked("3", &[]);
}

#[test]
fn nothing_can_panic_or_allocate_in_small_code() {
    let firmware = linked("s", &[]);
    assert!(names(&firmware, "memcpy"), "the names of what is called are in the file");
}

#[test]
fn nothing_can_panic_or_allocate_in_the_smallest_code() {
    linked("z", &[]);
}

#[test]
fn process_data_cannot_panic_or_allocate_even_in_code_that_is_not_optimised() {
    linked("0", &["--cfg=only_process_data"]);
}

/// The proof of the proof.
#[test]
fn what_can_panic_does_not_link() {
    let out = tempfile::tempdir().expect("there is room");
    let output = link("3", &["--cfg=with_a_panic", "--cfg=only_process_data"], out.path());
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(!output.status.success() && message.contains(MISSING), "{message}");
}
