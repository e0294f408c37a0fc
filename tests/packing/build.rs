//! Compiles `images.c` at the level of optimisation of the crate.

use std::env::var;
use std::path::Path;
use std::process::Command;

const SOURCE: &str = "src/packing/images.c";

fn main() {
    println!("cargo:rerun-if-changed={SOURCE}");
    let (level, out) = (var("OPT_LEVEL").expect("cargo sets it"), var("OUT_DIR").expect("cargo sets it"));
    let (object, library) = (Path::new(&out).join("images.o"), Path::new(&out).join("libimages.a"));
    if !compiles(&level, &object) {
        // not every compiler has -Oz
        assert!(level == "z" && compiles("s", &object), "{SOURCE} does not compile");
    }
    let archived = Command::new("ar").arg("crs").arg(library).arg(object).status();
    assert!(archived.is_ok_and(|status| status.success()), "there is no archive of {SOURCE}");
    println!("cargo:rustc-link-search=native={out}");
    println!("cargo:rustc-link-lib=static=images");
}

fn compiles(level: &str, object: &Path) -> bool {
    let compiler = var("CC").unwrap_or_else(|_| "cc".to_owned());
    let mut command = Command::new(compiler);
    command.arg(format!("-O{level}")).args(["-c", SOURCE, "-o"]).arg(object);
    command.status().is_ok_and(|status| status.success())
}
