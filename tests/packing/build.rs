//! Compiles `packing.c` at the level of optimisation of the crate.

use std::env::var;
use std::path::Path;
use std::process::Command;

fn main() {
    println!("cargo:rerun-if-changed=src/packing/packing.c");
    let (level, out) = (var("OPT_LEVEL").expect("cargo sets it"), var("OUT_DIR").expect("cargo sets it"));
    let (object, library) = (Path::new(&out).join("packing.o"), Path::new(&out).join("libpacking.a"));
    // not every compiler has -Oz
    let level = if level == "z" { "s".to_owned() } else { level };
    let compiler = var("CC").unwrap_or_else(|_| "cc".to_owned());
    run(Command::new(compiler)
        .arg(format!("-O{level}"))
        .args(["-c", "src/packing/packing.c", "-o"])
        .arg(&object));
    run(Command::new("ar").arg("crs").arg(library).arg(object));
    println!("cargo:rustc-link-search=native={out}");
    println!("cargo:rustc-link-lib=static=packing");
}

fn run(command: &mut Command) {
    let status = command.status().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(status.success(), "{command:?}: {status}");
}
