//! Mistakes and what rustc says of them: `ui/<name>.rs` is a program with mistakes, `ui/<name>.stderr` the messages. A
//! new program is a new case; `cargo accept` writes its messages.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::Mutex;
use std::{env, fs, thread};

use crate::built::{FLAGS, root};
use crate::plain::plain;

/// The programs, as seen from the workspace, by name.
fn cases() -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join("macros/tests/ui")).expect("there are cases");
    let files = entries.map(|entry| Path::new("macros/tests/ui").join(entry.expect("a case").file_name()));
    let mut files: Vec<_> = files.filter(|file| file.extension().is_some_and(|end| end == "rs")).collect();
    files.sort();
    files
}

/// Compiles a program. It lies in the workspace as if that were its package, and so do the devices.
fn compile(case: &Path, out: &Path) -> Output {
    Command::new(env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()))
        .args(["--edition=2024", "--emit=metadata", "--color=never", "--diagnostic-width=140"])
        .args(FLAGS.iter())
        .arg("--out-dir")
        .args([out, case])
        .current_dir(root())
        .env("CARGO_MANIFEST_DIR", root())
        .output()
        .expect("there is a compiler")
}

/// What is wrong with the messages of a case, if anything is.
fn judge(case: &Path, out: &Path) -> Option<String> {
    let output = compile(case, out);
    if output.status.success() {
        return Some(format!("{} compiles", case.display()));
    }
    let (found, file) =
        (plain(&String::from_utf8_lossy(&output.stderr)), root().join(case).with_extension("stderr"));
    let expected = fs::read_to_string(&file).unwrap_or_default();
    if found == expected {
        return None;
    }
    if env::var_os("DEVC_BLESS").is_some() {
        fs::write(&file, found).expect("messages can be written");
        return None;
    }
    Some(format!("{}\n--- expected\n{expected}--- found\n{found}", file.display()))
}

#[test]
fn mistakes_get_their_messages() {
    let (cases, out) = (cases(), tempfile::tempdir().expect("there is room"));
    let (left, wrong) = (Mutex::new(cases.iter()), Mutex::new(Vec::new()));
    let next = || left.lock().expect("no other thread panics").next();
    let work = || {
        while let Some(case) = next() {
            let found = judge(case, out.path());
            wrong.lock().expect("no other thread panics").extend(found);
        }
    };
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(work);
        }
    });
    let wrong = wrong.into_inner().expect("no thread has panicked");
    assert!(
        !cases.is_empty() && wrong.is_empty(),
        "{}\n`cargo accept` takes what was found",
        wrong.join("\n\n")
    );
}
