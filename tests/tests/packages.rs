//! What a registry gets: each package that is published has all that it is made of, and says what it is.

#![allow(clippy::expect_used, clippy::panic, clippy::indexing_slicing)] // a test may

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use toml::{Table, Value};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the workspace").to_owned()
}

fn manifest(folder: &Path) -> Table {
    let text = fs::read_to_string(folder.join("Cargo.toml")).expect("a manifest");
    text.parse().expect("TOML")
}

/// The folders of the packages that are published, with their manifests.
fn published() -> Vec<(PathBuf, Table)> {
    let workspace = manifest(&root());
    let members = workspace["workspace"]["members"].as_array().expect("members").iter();
    let folders = members.map(|member| root().join(member.as_str().expect("a folder")));
    let all = folders.map(|folder| (folder.clone(), manifest(&folder)));
    all.filter(|(_, manifest)| manifest["package"].get("publish") != Some(&Value::Boolean(false))).collect()
}

/// The files that a package would have.
fn listed(name: &str) -> BTreeSet<String> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["package", "--list", "--allow-dirty", "--offline", "--quiet", "--package", name]);
    let output = cargo.current_dir(root()).output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).lines().map(|line| line.replace('\\', "/")).collect()
}

/// All files in a folder, by their paths from `base` on.
fn files(base: &Path, folder: &Path, into: &mut BTreeSet<String>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files(base, &path, into);
        } else {
            let parts = path.strip_prefix(base).expect("it is inside").components();
            let parts: Vec<_> = parts.map(|part| part.as_os_str().to_string_lossy().into_owned()).collect();
            into.insert(parts.join("/"));
        }
    }
}

/// The files that a source text includes, by their paths from the package on.
fn included(source: &str, text: &str) -> Vec<String> {
    let paths = text.split("include_str!(\"").skip(1).filter_map(|rest| rest.split('"').next());
    let joined = |path: &str| {
        let mut parts: Vec<&str> = source.split('/').collect();
        parts.pop();
        for part in path.split('/') {
            match part {
                ".." => _ = parts.pop().unwrap_or_else(|| panic!("{source} includes {path}")),
                _ => parts.push(part),
            }
        }
        parts.join("/")
    };
    paths.map(joined).collect()
}

#[test]
fn a_package_has_all_that_it_is_made_of() {
    for (folder, manifest) in published() {
        let name = manifest["package"]["name"].as_str().expect("a name");
        let listed = listed(name);
        let mut needed: BTreeSet<String> =
            ["README.md", "LICENSE-MIT", "LICENSE-APACHE"].map(str::to_owned).into();
        files(&folder, &folder.join("src"), &mut needed);
        let sources: Vec<String> = needed.iter().filter(|file| file.ends_with(".rs")).cloned().collect();
        for source in sources {
            let text = fs::read_to_string(folder.join(&source)).expect("a source");
            needed.extend(included(&source, &text));
        }
        let missing: Vec<&String> = needed.difference(&listed).collect();
        assert!(missing.is_empty(), "{name} is without {missing:?}");
        let tests: Vec<&String> = listed.iter().filter(|file| file.starts_with("tests/")).collect();
        assert!(tests.is_empty(), "{name} has tests that need what is beside it: {tests:?}");
    }
}

#[test]
fn a_package_says_what_it_is() {
    let published = published();
    let names: Vec<&str> = published.iter().filter_map(|(_, it)| it["package"]["name"].as_str()).collect();
    assert!(names.contains(&"devc-cli") && names.contains(&"devc-runtime"), "{names:?}");
    for ((_, manifest), name) in published.iter().zip(&names) {
        let package = manifest["package"].as_table().expect("a table");
        for key in ["description", "license", "readme", "categories", "keywords"] {
            assert!(package.contains_key(key), "{name} has no {key}");
        }
        // what the registry takes at most
        for key in ["categories", "keywords"] {
            let words = package[key].as_array().expect("words");
            assert!((1..=5).contains(&words.len()), "{name} has {} {key}", words.len());
        }
    }
}

/// What a user's build needs has to be on the registry as well, and what it does not need must not be asked for there.
#[test]
fn packages_stand_on_packages_that_are_published() {
    let published = published();
    let names: Vec<&str> = published.iter().filter_map(|(_, it)| it["package"]["name"].as_str()).collect();
    let workspace = manifest(&root());
    let shared = &workspace["workspace"]["dependencies"];
    for (_, manifest) in &published {
        for (kind, is_needed) in [("dependencies", true), ("dev-dependencies", false)] {
            let Some(dependencies) = manifest.get(kind).and_then(Value::as_table) else { continue };
            for (name, dependency) in dependencies {
                let inherits = dependency.get("workspace").is_some();
                let dependency = if inherits { &shared[name] } else { dependency };
                let (is_here, has_version) =
                    (dependency.get("path").is_some(), dependency.get("version").is_some());
                let is_published =
                    names.contains(&dependency.get("package").and_then(Value::as_str).unwrap_or(name));
                assert!(
                    !is_here || is_needed == has_version && (is_published || !is_needed),
                    "{kind}: {name}"
                );
            }
        }
    }
}
