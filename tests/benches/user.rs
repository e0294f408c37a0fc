//! What a user's build pays for a device: `cargo build` of a crate with the C-887, against an empty crate.
//!
//! `cargo bench -p devc-tests --bench user [-- ROUNDS]`. What the crates depend on is built once before; then in every
//! round each crate is built twice, one crate after the other:
//!
//! - *clean*: its own code is compiled anew;
//! - *changed*: a line of its own code has changed.
//!
//! The crates: *empty* has nothing; *file* has the generated file as a module; *derive* has the description, through
//! the derive. All three depend on `devc-runtime` with its derive.
#![allow(clippy::print_stdout, reason = "a benchmark is there to print")]

#[allow(dead_code, reason = "this benchmark counts no instructions")]
mod measure;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};
use std::{env, fs};

use measure::{Fallible, run};

const ROUNDS: usize = 9;

const MANIFEST: &str = r#"
[package]
name = "NAME"
edition = "2024"

[dependencies]
devc-runtime = { path = "RUNTIME", features = ["derive"] }

[workspace]
"#;

const MAIN: &str = "fn main() {}\n";

const FILE: &str = r#"
mod c887;

fn main() {
    println!("{:?}", c887::Outputs::unpack([0; 42]));
}
"#;

const DERIVE: &str = r#"
#[derive(devc_runtime::Device)]
#[device(path = "c887")]
pub struct C887;

fn main() {
    println!("{:?}", c887::Outputs::unpack([0; 42]));
}
"#;

fn main() -> Fallible<()> {
    let rounds = env::args().skip(1).find_map(|argument| argument.parse().ok()).unwrap_or(ROUNDS);
    let folder = tempfile::tempdir()?;
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize()?;
    let mut users = [("empty", MAIN), ("file", FILE), ("derive", DERIVE)]
        .into_iter()
        .map(|(name, main)| User::new(folder.path(), &root, name, main))
        .collect::<Fallible<Vec<_>>>()?;
    for user in &mut users {
        user.build()?;
    }
    for round in 0..rounds {
        users.iter_mut().try_for_each(|user| user.round(round))?;
    }
    print(&users);
    Ok(())
}

/// A crate of a user.
struct User {
    name: &'static str,
    main: &'static str,
    folder: PathBuf,
    target: PathBuf,
    clean: Vec<Duration>,
    changed: Vec<Duration>,
}

impl User {
    fn new(folder: &Path, root: &Path, name: &'static str, main: &'static str) -> Fallible<Self> {
        let (target, folder) = (folder.join("target"), folder.join(name));
        fs::create_dir_all(folder.join("src"))?;
        fs::create_dir_all(folder.join("c887"))?;
        let runtime = root.join("runtime").display().to_string().replace('\\', "/");
        fs::write(folder.join("Cargo.toml"), MANIFEST.replace("NAME", name).replace("RUNTIME", &runtime))?;
        fs::copy(root.join("Cargo.lock"), folder.join("Cargo.lock"))?;
        fs::copy(root.join("generated/c887/c887.rs"), folder.join("src/c887.rs"))?;
        for file in fs::read_dir(root.join("devices/c887"))? {
            let file = file?;
            fs::copy(file.path(), folder.join("c887").join(file.file_name()))?;
        }
        fs::write(folder.join("src/main.rs"), main)?;
        Ok(Self { name, main, folder, target, clean: Vec::new(), changed: Vec::new() })
    }

    fn cargo(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO"));
        command.args(arguments).args(["--quiet", "--offline"]);
        command.current_dir(&self.folder).env("CARGO_TARGET_DIR", &self.target);
        command
    }

    fn build(&self) -> Fallible<Duration> {
        let start = Instant::now();
        run(&mut self.cargo(&["build"]))?;
        Ok(start.elapsed())
    }

    fn round(&mut self, round: usize) -> Fallible<()> {
        run(&mut self.cargo(&["clean", "--package", self.name]))?;
        self.clean.push(self.build()?);
        let changed = format!("{}\npub const ROUND: usize = {round};\n", self.main);
        fs::write(self.folder.join("src/main.rs"), changed)?;
        self.changed.push(self.build()?);
        Ok(())
    }
}

fn print(users: &[User]) {
    println!("{:<10}{:>12}{:>12}{:>12}{:>12}", "crate", "clean", "of empty", "changed", "of empty");
    let Some(empty) = users.first() else { return };
    for user in users {
        let ratio = |own: &[Duration], other: &[Duration]| {
            median(own.iter().zip(other).map(|(own, other)| own.as_secs_f64() / other.as_secs_f64()))
        };
        let ms = |times: &[Duration]| median(times.iter().map(|time| time.as_secs_f64() * 1e3));
        let (clean, changed) = (ms(&user.clean), ms(&user.changed));
        let (of_clean, of_changed) = (ratio(&user.clean, &empty.clean), ratio(&user.changed, &empty.changed));
        println!("{:<10}{clean:>9.0} ms{of_clean:>11.1}x{changed:>9.0} ms{of_changed:>11.1}x", user.name);
    }
}

/// The middle one.
fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}
