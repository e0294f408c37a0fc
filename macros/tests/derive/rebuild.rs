//! A change of the description rebuilds the user's crate.

use std::fs;
use std::path::Path;

use crate::built::{FLAGS, cargo};

/// The runtime is no dependency here: it is built already, and rustc is told where.
const MANIFEST: &str = r#"
[package]
name = "drive"
edition = "2024"

[workspace]
"#;

const MAIN: &str = r#"
#[derive(devc_runtime::Device)]
#[device(path = "device.toml")]
pub struct Drive;

fn main() {
    println!("{}", <Drive as devc_runtime::Device>::NAME);
}
"#;

const DESCRIPTION: &str = r#"
[device]
name = "NAME"
vendor = "Somebody"
title = "A drive"

[identity]
vendor-id = 1
product-code = 2
revision = 3
"#;

/// Builds and runs the crate.
fn run(crate_root: &Path) -> String {
    let output = cargo()
        .arg("run")
        .current_dir(crate_root)
        .env("CARGO_TARGET_DIR", crate_root.join("target"))
        .env("CARGO_ENCODED_RUSTFLAGS", FLAGS.join("\x1f"))
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).trim().to_owned()
}

#[test]
fn a_change_of_the_description_rebuilds() {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("a file");
    fs::create_dir(folder.path().join("src")).expect("a folder");
    write("Cargo.toml", MANIFEST);
    write("src/main.rs", MAIN);
    for name in ["first", "second"] {
        write("device.toml", &DESCRIPTION.replace("NAME", name));
        assert_eq!(run(folder.path()), name);
    }
}
