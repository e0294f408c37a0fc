//! Compiles the functions in C at the level of optimisation of the crate, with the headers that devc has put into the folder
//! `HEADERS`.

use std::env::var;
use std::path::{Path, PathBuf};
use std::process::Command;

const SOURCES: [&str; 2] = ["images", "generated"];

fn main() {
    println!("cargo:rerun-if-env-changed=HEADERS");
    let (level, out) = (var("OPT_LEVEL").expect("cargo sets it"), var("OUT_DIR").expect("cargo sets it"));
    let objects = SOURCES.map(|source| compiled(source, &level, Path::new(&out)));
    let archived =
        Command::new("ar").arg("crs").arg(Path::new(&out).join("libimages.a")).args(objects).status();
    assert!(archived.is_ok_and(|status| status.success()), "there is no archive");
    println!("cargo:rustc-link-search=native={out}");
    println!("cargo:rustc-link-lib=static=images");
}

fn compiled(source: &str, level: &str, out: &Path) -> PathBuf {
    let path = format!("src/packing/{source}.c");
    println!("cargo:rerun-if-changed={path}");
    let object = out.join(source).with_extension("o");
    if !compiles(&path, level, &object) {
        // not every compiler has -Oz
        assert!(level == "z" && compiles(&path, "s", &object), "{path} does not compile");
    }
    object
}

fn compiles(source: &str, level: &str, object: &Path) -> bool {
    let compiler = var("CC").unwrap_or_else(|_| "cc".to_owned());
    let headers = var("HEADERS").expect("the benchmark sets it");
    let mut command = Command::new(compiler);
    command.arg(format!("-O{level}")).args(["-I", &headers, "-c", source, "-o"]).arg(object);
    command.status().is_ok_and(|status| status.success())
}
