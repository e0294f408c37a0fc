//! What a user sees who writes the derive rightly or wrongly.
//!
//! The cases stand here and not with the other tests because each is built with all that its crate depends on.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

#[test]
fn the_derive_compiles_or_says_why_not() -> io::Result<()> {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let package = package();
    copy(&here.join("../devices"), &package.join("devices"))?;
    copy(&here.join("tests/ui/typo"), &package.join("typo"))?;

    let cases = trybuild::TestCases::new();
    cases.pass("tests/ui/good.rs");
    cases.pass("tests/ui/renamed.rs");
    cases.compile_fail("tests/ui/no_path.rs");
    cases.compile_fail("tests/ui/missing.rs");
    cases.compile_fail("tests/ui/private.rs");
    cases.compile_fail("tests/ui/typo.rs");
    cases.compile_fail("tests/ui/wrong_access.rs");
    cases.compile_fail("tests/ui/wrong_quantity.rs");
    cases.compile_fail("tests/ui/forbidden_image.rs");
    cases.compile_fail("tests/ui/forbidden_mapping.rs");
    cases.compile_fail("tests/ui/mapping_settings.rs");
    Ok(())
}

/// The folder of the package that the cases are built in. It lies in the target directory, wherever that is, and
/// descriptions are found from there.
fn package() -> PathBuf {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).ancestors().nth(1).unwrap_or(Path::new("."));
    target.join("tests/trybuild").join(env!("CARGO_PKG_NAME"))
}

/// Copies a folder of descriptions, in place of what an earlier run left.
fn copy(from: &Path, to: &Path) -> io::Result<()> {
    if to.exists() {
        fs::remove_dir_all(to)?;
    }
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let entry = entry?;
        let to = to.join(entry.file_name());
        if entry.file_type()?.is_dir() {
            copy(&entry.path(), &to)?;
        } else {
            fs::copy(entry.path(), to)?;
        }
    }
    Ok(())
}
