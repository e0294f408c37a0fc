//! A change of the description rebuilds the user's crate.

use std::path::Path;
use std::process::Command;
use std::{env, fs};

const MANIFEST: &str = r#"
[package]
name = "drive"
edition = "2024"

[dependencies]
devc-runtime = { path = "RUNTIME", features = ["derive"] }

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
    let target = Path::new(env!("CARGO_MANIFEST_DIR")).join("../target/rebuild");
    let output = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
        .args(["run", "--quiet", "--offline"])
        .current_dir(crate_root)
        .env("CARGO_TARGET_DIR", target)
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).trim().to_owned()
}

#[test]
fn a_change_of_the_description_rebuilds() {
    let folder = tempfile::tempdir().expect("a folder");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("a file");
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let runtime = workspace.join("runtime").display().to_string().replace('\\', "/");
    fs::create_dir(folder.path().join("src")).expect("a folder");
    fs::copy(workspace.join("Cargo.lock"), folder.path().join("Cargo.lock")).expect("the lock file");
    write("Cargo.toml", &MANIFEST.replace("RUNTIME", &runtime));
    write("src/main.rs", MAIN);
    for name in ["first", "second"] {
        write("device.toml", &DESCRIPTION.replace("NAME", name));
        assert_eq!(run(folder.path()), name);
    }
}
