//! Process data to bytes and back, and finding an entry by its address, against other ways: in instructions, which
//! do not depend on what else the machine does.
//!
//! `cargo bench -p devc-tests --bench packing`. It needs valgrind and a C compiler, and builds `tests/packing`, which
//! is a workspace of its own, at each level of optimisation. What is compared with is a function in C that shifts each
//! field into its bytes, at the same level; the call itself is not counted.
#![allow(clippy::print_stdout, reason = "a benchmark is there to print")]

mod measure;

use std::collections::BTreeMap;
use std::env;
use std::path::PathBuf;
use std::process::Command;

use measure::{Fallible, instructions, run};

const LEVELS: [&str; 3] = ["3", "s", "z"];

/// How often each subject runs.
const ROUNDS: u32 = 1_000;

/// What the others are compared with.
const REFERENCE: &str = "C, field by field";

/// Instructions a call, by way and by what is done.
type Costs = BTreeMap<(String, String), f64>;

fn main() -> Fallible<()> {
    let mut levels = Vec::new();
    let mut ways: Vec<String> = Vec::new();
    for level in LEVELS {
        let program = built(level)?;
        let names = String::from_utf8(run(&mut Command::new(&program))?.stdout)?;
        let names: Vec<(&str, &str)> = names.lines().filter_map(|name| name.rsplit_once(", ")).collect();
        for (way, _) in &names {
            if !ways.iter().any(|known| known == way) {
                ways.push((*way).to_owned());
            }
        }
        levels.push(costs(&program, &names)?);
    }
    print(&ways, &levels);
    Ok(())
}

/// The program, built at a level of optimisation beside this benchmark's own.
fn built(level: &str) -> Fallible<PathBuf> {
    let own = env::current_exe()?;
    let folder = own.parent().and_then(|folder| folder.parent()?.parent()).ok_or("no target folder")?;
    let target = folder.join("packing");
    let manifest = concat!(env!("CARGO_MANIFEST_DIR"), "/packing/Cargo.toml");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--release", "--manifest-path", manifest, "--target-dir"]).arg(&target);
    run(cargo.env("CARGO_PROFILE_RELEASE_OPT_LEVEL", level))?;
    Ok(target.join("release").join("devc-packing").with_extension(env::consts::EXE_EXTENSION))
}

/// What each subject costs, without the call.
fn costs(program: &PathBuf, names: &[(&str, &str)]) -> Fallible<Costs> {
    let mut command = Command::new(program);
    let parts = instructions(command.arg(ROUNDS.to_string()), Some("next_subject"))?.ok_or("no valgrind")?;
    // the first part is that before the first subject
    let each = parts.iter().skip(1).map(|part| *part as f64 / f64::from(ROUNDS));
    let all: Costs = names
        .iter()
        .zip(each)
        .map(|((way, what), cost)| (((*way).to_owned(), (*what).to_owned()), cost))
        .collect();
    let nothing = |what: &String| all.get(&("nothing".to_owned(), what.clone())).copied().unwrap_or(0.0);
    Ok(all.iter().map(|(key, cost)| (key.clone(), cost - nothing(&key.1))).collect())
}

fn print(ways: &[String], levels: &[Costs]) {
    println!(
        "{:<20}{}",
        "of C, pack / unpack",
        LEVELS.map(|level| format!("{:>16}", format!("-O{level}"))).concat()
    );
    for way in ways.iter().filter(|way| *way != "nothing") {
        let cells = levels.iter().map(|costs| {
            let ratios = ["pack", "unpack"].map(|what| mean_ratio(costs, way, what));
            let [Some(pack), Some(unpack)] = ratios else { return format!("{:>16}", "") };
            format!("{:>16}", format!("{pack:.2} / {unpack:.2}"))
        });
        println!("{way:<20}{}", cells.collect::<String>());
    }
    println!("\ninstructions a lookup");
    for way in ways.iter().filter(|way| *way != "nothing") {
        let cost = |costs: &Costs| costs.get(&(way.clone(), "lookup".to_owned())).copied();
        let cells: Vec<String> = levels.iter().filter_map(cost).map(|cost| format!("{cost:>16.1}")).collect();
        if !cells.is_empty() {
            println!("{way:<20}{}", cells.concat());
        }
    }
}

/// The geometric mean over the images of how much more it costs than the reference.
fn mean_ratio(costs: &Costs, way: &str, what: &str) -> Option<f64> {
    let ratios = ["outputs", "inputs"].map(|image| {
        let cost = |way: &str| costs.get(&(way.to_owned(), format!("{what} {image}")));
        Some(cost(way)? / cost(REFERENCE)?)
    });
    let [Some(outputs), Some(inputs)] = ratios else { return None };
    Some((outputs * inputs).sqrt())
}
