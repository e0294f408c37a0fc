//! Puts all changes that cargo-mutants would make into one copy of the code, each behind a switch that the environment
//! turns, so that one build asks about thousands of them:
//!
//!     switches CHANGES.json FROM TO LEFT-OUT
//!
//! reads sources below FROM and writes them with switches below TO, without the changes whose numbers are in the file
//! LEFT-OUT. It prints a line for each piece: file, first byte, byte behind the last, and the number of the change it is of,
//! from 1; or `alone` and the number of a change that no switch can make.

mod nodes;
mod weave;

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::path::Path;
use std::{env, fs};

use weave::{Change, Weaver};

const SWITCH: &str = include_str!("../switch.rs");

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [changes, from, to, left_out] = arguments.as_slice() else {
        return Err("CHANGES FROM TO LEFT-OUT".into());
    };
    let (from, to) = (Path::new(from), Path::new(to));
    let changes: Vec<Change> = serde_json::from_str(&fs::read_to_string(changes)?)?;
    let left_out: BTreeSet<usize> =
        fs::read_to_string(left_out)?.split_whitespace().map(str::parse).collect::<Result<_, _>>()?;
    let mut files = BTreeMap::<&str, Vec<(usize, &Change)>>::new();
    for (number, change) in (1..).zip(&changes).filter(|(number, _)| !left_out.contains(number)) {
        files.entry(&change.file).or_default().push((number, change));
    }
    for (file, changes) in &files {
        let text = fs::read_to_string(from.join(file))?;
        let mut weaver = Weaver::new(&text)?;
        for (number, change) in changes {
            if !weaver.weave(*number, change) {
                println!("alone {number}");
            }
        }
        let woven = weaver.finish();
        for (place, number) in woven.places {
            println!("{file} {} {} {number}", place.start, place.end);
        }
        write(&to.join(file), &woven.text)?;
    }
    let packages: BTreeSet<&str> =
        files.keys().filter_map(|file| file.split_once("/src/")).map(|(it, _)| it).collect();
    packages.into_iter().try_for_each(|package| turn(&from.join(package), &to.join(package)))
}

/// The module that the switches are in. Attributes of the crate stand behind its docs.
fn turn(from: &Path, to: &Path) -> Result<(), Box<dyn Error>> {
    let text = fs::read_to_string(from.join("src/lib.rs"))?;
    let docs: usize =
        text.lines().take_while(|line| line.starts_with("//!")).map(|line| line.len() + 1).sum();
    let (docs, code) = text.split_at(docs);
    let head = "#![feature(core_intrinsics, const_eval_select)]\n#![allow(warnings)]\n";
    write(&to.join("src/lib.rs"), &format!("{docs}{head}{code}\n#[doc(hidden)]\npub mod switch;\n"))?;
    write(&to.join("src/switch.rs"), SWITCH)
}

/// What is the same stays as it is, so that it is not built again.
fn write(path: &Path, text: &str) -> Result<(), Box<dyn Error>> {
    if fs::read_to_string(path).ok().as_deref() != Some(text) {
        fs::write(path, text)?;
    }
    Ok(())
}
